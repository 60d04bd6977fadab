// The engine of Dashpad as a WebAssembly module: requests and answers are objects (src/live/answer.hpp).

// Starts a compiled module, which has the cards and standards that come with it, and adds others by their paths:
// {"materials/my-foam.toml": text, ...}. An answer that ends the engine, as by a lack of memory, throws; the engine is then
// to be started anew.
export function startEngine(module, files = {}) {
  const refused = (text) => {
    throw new Error(text);
  };
  const text = (place, size) => new TextDecoder().decode(new Uint8Array(memory.buffer, place, size));
  const instance = new WebAssembly.Instance(module, {
    host: { refuse: (place, size) => refused(text(place, size)) },
    wasi_snapshot_preview1: {
      environ_get: () => 0,
      environ_sizes_get: (count, size) => {
        new DataView(memory.buffer).setUint32(count, 0, true);
        new DataView(memory.buffer).setUint32(size, 0, true);
        return 0;
      },
      clock_time_get: (_clock, _precision, place) => {
        new DataView(memory.buffer).setBigUint64(place, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      fd_close: () => 8,
      fd_seek: () => 8,
      fd_write: () => 8,
      proc_exit: () => refused("the engine has stopped"),
    },
  });
  const { memory, _initialize, allocate, add_file, refuse_file, missing_files, answer, result_size } = instance.exports;
  _initialize();
  const put = (words) => {
    const bytes = typeof words === "string" ? new TextEncoder().encode(words) : words;
    const place = allocate(bytes.length);
    new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
    return [place, bytes.length];
  };
  const addFile = (name, content) => add_file(...put(name), ...put(content));
  for (const [name, content] of Object.entries(files)) addFile(name, content);
  return {
    // A text or bytes.
    addFile,
    // A file that is there and cannot be read, or a folder that is not, and why.
    refuseFile: (name, why) => refuse_file(...put(name), ...put(why)),
    // The files that answers have looked for in vain since the last call.
    missingFiles: () => text(missing_files(), result_size()).split("\n").slice(0, -1),
    ask: (request) => {
      const place = answer(...put(JSON.stringify(request)));
      return JSON.parse(text(place, result_size()));
    },
  };
}
