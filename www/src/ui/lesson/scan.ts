/** Reads the QR code in a photo: with the browser's own reader where it has one, else with one that comes now. */

interface Detector {
  detect(image: ImageBitmap): Promise<readonly { readonly rawValue: string }[]>;
}

/** A side of what is looked through, px. */
const SIDE_PX = 1600;

/** The text of the code; null where there is none to be read. */
export async function scanned(photo: Blob): Promise<string | null> {
  const image = await createImageBitmap(photo);
  try {
    return (await byBrowser(image)) ?? (await byScript(image));
  } finally {
    image.close();
  }
}

async function byBrowser(image: ImageBitmap): Promise<string | null> {
  const { BarcodeDetector } = globalThis as { BarcodeDetector?: new (options: object) => Detector };
  if (!BarcodeDetector) return null;
  try {
    const [code] = await new BarcodeDetector({ formats: ["qr_code"] }).detect(image);
    return code?.rawValue ?? null;
  } catch {
    // There, but not on this device.
    return null;
  }
}

async function byScript(image: ImageBitmap): Promise<string | null> {
  const { default: jsQR } = await import("jsqr");
  const scale = Math.min(1, SIDE_PX / Math.max(image.width, image.height));
  const [width, height] = [Math.round(image.width * scale), Math.round(image.height * scale)];
  const context = new OffscreenCanvas(width, height).getContext("2d")!;
  context.drawImage(image, 0, 0, width, height);
  return jsQR(context.getImageData(0, 0, width, height).data, width, height)?.data ?? null;
}
