import { runnerImport } from "vite";
const { module } = await runnerImport("./look.mts", { configFile: false, logLevel: "error" });
await module.look(process.argv[2]); 
