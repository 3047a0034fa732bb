// The prover in a worker: the page stays usable, and the page can stop it.
import { loadPyodide } from "./pyodide.mjs";

const say = (stage, part = null) => postMessage({ stage, part });

async function content(name) {
  const response = await fetch(new URL(name, import.meta.url));
  if (!response.ok) throw new Error(`${name} cannot be loaded (${response.status})`);
  return response;
}

const bytes = async (name) => new Uint8Array(await (await content(name)).arrayBuffer());

async function start() {
  say("Python is loading");
  const python = await loadPyodide();
  imported(python, "/algebroproj_sym.zip", await bytes("algebroproj_sym.zip"));
  const answering = python.pyimport("algebroproj_sym.reporting.live.answering");
  say(null);
  return { python, answering };
}

async function prepare() {
  const modules = await (await content("modules.json")).json();
  const contents = modules.map(({ file }) => bytes(file));
  const [{ python, answering }] = await Promise.all([started(), ...contents]);
  for (const [place, { name, file }] of modules.entries()) {
    say(`${name} is loading`, place / (modules.length + 1));
    if (file.endsWith(".whl")) python.unpackArchive(await contents[place], "wheel");
    else imported(python, `/${file}`, await contents[place]);
  }
  say("the prover is starting", modules.length / (modules.length + 1));
  answering.answer(JSON.stringify({ do: "prepare" }));
  say(null);
}

function imported(python, path, archive) {
  python.FS.writeFile(path, archive);
  python.runPython(`import sys; sys.path.insert(0, "${path}")`);
}

let starting;
let preparing;
const started = () => (starting ??= start());
const prepared = () => (preparing ??= prepare());

let last = Promise.resolve();

async function respond({ id, question }) {
  try {
    const { answering } = await started();
    if (question.do === "start") return postMessage({ id, answer: {} });
    if (question.do !== "replay") await prepared();
    if (question.do === "prepare") return postMessage({ id, answer: {} });
    postMessage({ id, answer: JSON.parse(answering.answer(JSON.stringify(question))) });
  } catch (error) {
    postMessage({ id, answer: { error: String(error.message ?? error) } });
  }
}

onmessage = ({ data }) => {
  last = last.then(() => respond(data));
};
