/** The worker that pictures and films are made in. */

import { Lab } from "./lab";
import type { Order } from "./orders";

const lab = new Lab((told, transfer) => postMessage(told, { transfer }));

onmessage = ({ data }: MessageEvent<Order>) => void lab.hear(data);
