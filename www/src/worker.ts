/** The engine's worker: what every task's engine can do. */

import { serve } from "./engine/serve";
import { ENGINES } from "./tasks/engines";

serve(ENGINES);
