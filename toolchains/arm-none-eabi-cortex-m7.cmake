# A bare Cortex-M7, no operating system; start-up code and memory map are those of hil/bare_metal. Debian: gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# What follows -fdata-sections: gcc 12 otherwise keeps more numbers at once than there are registers, and widens some before they are multiplied; a tick is a
# fifth longer.
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16 -ffunction-sections -fdata-sections -fno-schedule-insns -fno-tree-pre -fno-code-hoisting -fno-tree-vrp -fno-tree-ter -fweb -flive-range-shrinkage")
