/// Where frames come from. Each source runs in a thread of its own and puts what it has into the inbox, until there is no more or nobody takes any more.
///
/// fails     each: InputError naming what could not be read
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/cloud/placement.h"
#include "host/cloud/source_file.h"
#include "host/evaluate/depth_camera.h"
#include "host/stream/inbox.h"

namespace isotouch::stream {

using Source = std::function<void(Inbox&)>;

/// One frame a file, in this order. At a pace, the inbox thins them; without one each waits until the one before was taken.
///
/// rate      frames a second
Source files(std::vector<std::filesystem::path> files, std::optional<double> rate, const cloud::SensorOptions& sensor);

/// Standard input, in frames (frame_reader.h).
///
/// waits     for each frame to be taken, so that none is left out and the writer waits, too
Source standard_input(const cloud::SensorOptions& sensor, bool waits);

/// What a recorded hand felt: a frame for each `1 / rate` s of its ticks, in workspace mm. It waits, or comes at its own pace.
///
/// in_time   at its own pace
Source recording(std::filesystem::path file, double rate, bool in_time);

/// What is felt at a running controller, as it is felt.
Source controller(std::string address, double rate);

/// A depth camera that goes round a mesh, in the mesh's frame. Frames that it cannot compute in time are left out, too.
///
/// tree      of the mesh as it lies in the workspace; stays alive as long as the source
/// placement leads from the mesh's frame there
/// options   its rate is the pace
Source depth_camera(const field::TriangleTree& tree, const cloud::Placement& placement, const evaluate::DepthCameraOptions& options);

/// Runs a source; the thread ends by itself when the inbox is closed.
std::jthread run(Source source, Inbox& inbox);

}  // namespace isotouch::stream
