// One script, one sheet and one page with fixed names: the program carries them, and the check compares them byte for byte.
import { createHash } from 'node:crypto';
import { defineConfig } from 'vite';

/** What a page in a file may do (isotouch view --export): run this very script and sheet, and the core in a worker; nothing else, and ask nobody. */
const policyOfFile = {
  name: 'policy-of-file',
  generateBundle(_: unknown, bundle: Record<string, { type: string; code?: string; source?: string | Uint8Array }>): void {
    const hash = (content: string): string => `'sha256-${createHash('sha256').update(content.replaceAll('</script', '<\\/script')).digest('base64')}'`;
    const policy = [
      "default-src 'none'",
      `script-src ${hash(bundle['page.js']?.code ?? '')} blob: 'wasm-unsafe-eval'`,
      `style-src ${hash(String(bundle['page.css']?.source ?? ''))}`,
      'worker-src blob:',
      'img-src data:',
      "base-uri 'none'",
      "form-action 'none'",
    ].join('; ');
    (this as unknown as { emitFile(file: object): void }).emitFile({ type: 'asset', fileName: 'policy.txt', source: policy });
  },
};

export default defineConfig({
  base: './',
  publicDir: false, // the program carries public/touch.wasm as it lies there
  plugins: [{ ...policyOfFile, enforce: 'post' }],
  worker: { format: 'iife', rollupOptions: { output: { entryFileNames: 'touch_worker.js' } } },
  build: {
    target: 'es2022',
    modulePreload: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1000,
    rollupOptions: {
      output: { entryFileNames: 'page.js', assetFileNames: 'page.[ext]', inlineDynamicImports: true },
    },
  },
});
