// The engine in a worker: one request at a time, of those that wait only the last, and an end to what does not end.

// Starts the engine in the worker when its compiled module comes, then answers.
const workerText = `
${startEngine}
let engine, module, files;
onmessage = ({ data }) => {
  if (data.module) [module, files] = [data.module, data.files];
  try {
    engine ??= startEngine(module, files);
    if (data.request) postMessage({ id: data.id, answer: engine.ask(data.request) });
  } catch (error) {
    engine = undefined;
    postMessage({ id: data.id, answer: { faults: [{ key: "", rule: "", text: error.message }] } });
  }
};`;

class EngineWorker {
  constructor(module, files = {}) {
    this.module = module;
    this.files = { ...files };
    this.url = URL.createObjectURL(new Blob([workerText], { type: "text/javascript" }));
    this.count = 0;
    this.start();
  }

  start() {
    this.worker = new Worker(this.url);
    this.worker.onmessage = ({ data }) => this.took(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.giveUp("this cannot be computed in a browser");
    };
    this.worker.postMessage({ module: this.module, files: this.files });
    this.asked = null;
  }

  // Files of the reader's own; where one is new the engine starts anew with it.
  addFiles(files) {
    if (Object.entries(files).every(([name, text]) => this.files[name] === text)) return;
    Object.assign(this.files, files);
    this.worker.terminate();
    if (this.asked) clearTimeout(this.asked.guard);
    this.asked?.resolve(null);
    this.start();
    this.send();
  }

  // The answer, or null if a later request of the same kind took its place. `command` answers what takes longer.
  ask(request, seconds = 10, command = "the command") {
    return new Promise((resolve) => {
      this.waiting?.resolve(null);
      this.waiting = { request, seconds, command, resolve };
      this.send();
    });
  }

  send() {
    if (this.asked || !this.waiting) return;
    this.asked = { ...this.waiting, id: ++this.count };
    this.waiting = null;
    const { seconds, command } = this.asked;
    this.asked.guard = setTimeout(() => this.giveUp(`no answer within ${seconds} s; ${command} has more time`), 1000 * seconds);
    this.worker.postMessage({ id: this.asked.id, request: this.asked.request });
  }

  took({ id, answer }) {
    if (id !== this.asked?.id) return;
    const { resolve, guard } = this.asked;
    clearTimeout(guard);
    this.asked = null;
    resolve(answer);
    this.send();
  }

  giveUp(rule) {
    if (!this.asked) return;
    const { resolve, guard } = this.asked;
    clearTimeout(guard);
    this.worker.terminate();
    this.start();
    resolve({ faults: [{ key: "", rule, text: rule }] });
    this.send();
  }
}

// The module, which the page holds packed and in Base64.
const compiledEngine = async () => WebAssembly.compile(unpacked(Uint8Array.from(atob(byId("engine").textContent), (letter) => letter.charCodeAt(0))));
