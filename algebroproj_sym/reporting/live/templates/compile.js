// Compiles the modules of the wheels that are named, each to a ZIP file beside it.
import { readFileSync, writeFileSync } from "node:fs";
import { loadPyodide } from "./pyodide.mjs";

const python = await loadPyodide({ env: { PYTHONHASHSEED: "0" } });
python.runPython(readFileSync("compiling.py", "utf8"));
for (const name of process.argv.slice(2)) {
  python.FS.writeFile("/wheel", new Uint8Array(readFileSync(name)));
  python.runPython('open("/modules", "wb").write(compiled(open("/wheel", "rb").read()))');
  writeFileSync(`${name}.zip`, python.FS.readFile("/modules"));
}
