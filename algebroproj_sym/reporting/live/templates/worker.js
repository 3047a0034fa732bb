// The prover in a worker: the page stays usable, and the page can stop it.
import { loadPyodide } from "./pyodide.mjs";

const ROOT = "/prover";

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
  python.unpackArchive(await bytes("algebroproj_sym.zip"), "zip", { extractDir: ROOT });
  python.runPython(`import sys; sys.path.insert(0, "${ROOT}")`);
  const answering = python.pyimport("algebroproj_sym.reporting.live.answering");
  say(null);
  return { python, answering };
}

async function prepare() {
  const { python, answering } = await started();
  const wheels = await (await content("wheels.json")).json();
  for (const [place, wheel] of wheels.entries()) {
    say(`${wheel.name} is loading`, place / (wheels.length + 1));
    python.unpackArchive(await bytes(wheel.file), "wheel");
  }
  say("the prover is starting", wheels.length / (wheels.length + 1));
  answering.answer(JSON.stringify({ do: "prepare" }));
  say(null);
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
