import init, { version } from "./wasm/wire4d";
import moduleUrl from "./wasm/wire4d_bg.wasm?url";

await init({ module_or_path: moduleUrl });
postMessage(version());
