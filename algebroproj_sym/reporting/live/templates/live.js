"use strict";

// One worker for a page.  It is started when the page is idle, and started anew after it was stopped.
const HERE = document.currentScript.src;

class Prover {
  constructor(tell) {
    this.tell = tell;
    this.asked = new Map();
    this.count = 0;
  }

  ask(question) {
    if (!this.worker) {
      this.worker = new Worker(new URL("worker.js", HERE), { type: "module" });
      this.worker.onmessage = ({ data }) => this.receive(data);
      this.worker.onerror = (event) => this.fail(event.message || "The prover cannot be loaded.");
    }
    const id = this.count++;
    this.worker.postMessage({ id, question });
    return new Promise((resolve) => this.asked.set(id, resolve));
  }

  receive({ id, answer, stage, part }) {
    if (id === undefined) return this.tell(stage, part);
    const resolve = this.asked.get(id);
    this.asked.delete(id);
    resolve(answer);
  }

  fail(message) {
    this.worker?.terminate();
    this.worker = undefined;
    this.tell(null, null);
    for (const resolve of this.asked.values()) resolve({ error: message });
    this.asked.clear();
  }
}

const lines = (text) => text.split("\n").map((line) => line.trim()).filter(Boolean);

function sentences(answer) {
  if (answer.error) return ["not decided", answer.error];
  if (answer.status) return [answer.status, answer.reason || "The verdict follows from the evidence of the ledger."];
  const found = [answer.verdict];
  if (answer.verdict === "proved") found.push("It holds wherever both sides are defined.");
  if (answer.hypotheses.length) found.push(`It holds where ${answer.hypotheses.join(", ")}.`);
  const point = Object.entries(answer.counterexample).map(([name, value]) => `${name} = ${value}`);
  if (answer.verdict === "refuted" && point.length) found.push(`At ${point.join(", ")}:`);
  if (answer.verdict === "refuted" && answer.left.length) {
    found.push(`the left side is ${answer.left.join(", ")}`, `the right side is ${answer.right.join(", ")}`);
  }
  if (answer.reason) found.push(answer.reason);
  return found;
}

function show(place, answer) {
  const [verdict, ...rest] = sentences(answer);
  const badge = document.createElement("strong");
  badge.className = "verdict";
  badge.dataset.verdict = badge.textContent = verdict;
  place.replaceChildren(badge, ...rest.flatMap((text) => {
    const line = document.createElement("span");
    line.textContent = text;
    return [document.createElement("br"), line];
  }));
}

function begin(section) {
  section.hidden = false;
  const [status, result] = ["[role=status]", "output"].map((selector) => section.querySelector(selector));
  if (location.protocol === "file:") {
    status.textContent = "The prover needs a web server. In the folder of the site run python3 -m http.server, and open http://localhost:8000.";
    return;
  }
  const [form, stop, progress] = ["form", "[data-do=stop]", "progress"].map((selector) => section.querySelector(selector));
  const prover = new Prover((stage, part) => {
    status.textContent = stage ? `${stage} …` : "";
    progress.hidden = !stage;
    if (part === null) progress.removeAttribute("value");
    else progress.value = part;
  });
  section.prover = prover;
  let waiting = 0;
  const ask = async (question, isStillAsked = () => true) => {
    waiting++;
    stop.hidden = false;
    result.replaceChildren();
    const answer = await question().then((asked) => prover.ask(asked)).catch((error) => ({ error: error.message }));
    stop.hidden = --waiting === 0;
    if (isStillAsked()) show(result, answer);
  };
  const written = () => JSON.stringify([...new FormData(form)]);
  const { ledger, paper, number } = section.dataset;
  let entry;
  const claim = async () => (entry ??= (await (await fetch(ledger)).json()).claims.find((each) => each.paper === paper && each.number === number));
  const field = (name) => form.elements.namedItem(name)?.value ?? "";
  form?.addEventListener("submit", (event) => {
    event.preventDefault();
    const asked = written();
    ask(async () => ({
      do: "prove",
      lhs: field("lhs"),
      rhs: field("rhs"),
      relation: field("relation").trim() || "=",
      ...Object.fromEntries(["constraints", "nonzero", "assumptions", "letters"].map((name) => [name, lines(field(name))])),
      where: ledger ? (await claim()).where : {},
    }), () => written() === asked);
  });
  form?.addEventListener("input", () => result.replaceChildren());
  form?.addEventListener("focusin", () => prover.ask({ do: "prepare" }), { once: true });
  stop.addEventListener("click", () => prover.fail("Stopped."));
  section.querySelector("[data-do=replay]")?.addEventListener("click", () => ask(async () => ({ do: "replay", claim: await claim() })));
  if (navigator.connection?.saveData) return;
  const idle = window.requestIdleCallback ?? ((run) => setTimeout(run, 500));
  idle(() => prover.ask({ do: ledger ? "start" : "prepare" }));
}

document.querySelectorAll("[data-live]").forEach(begin);
