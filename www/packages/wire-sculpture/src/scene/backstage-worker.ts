/** The worker of the app's own page. */

import { serve } from "./serving";

serve();
