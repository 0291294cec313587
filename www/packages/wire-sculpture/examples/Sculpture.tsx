import { useEffect, useRef } from "react";
import "wire-sculpture";

interface Props {
  code: string;
  alt: string;
  onView?: (view: string) => void;
}

export function Sculpture({ code, alt, onView }: Props) {
  const element = useRef<HTMLElement>(null);

  useEffect(() => {
    const tell = (event: Event) => onView?.((event as CustomEvent<{ view: string }>).detail.view);
    const sculpture = element.current;
    sculpture?.addEventListener("view-change", tell);
    return () => sculpture?.removeEventListener("view-change", tell);
  }, [onView]);

  return <wire-sculpture ref={element} code={code} alt={alt} camera-controls="" shadow="" />;
}

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "wire-sculpture": React.HTMLAttributes<HTMLElement> & { ref?: React.Ref<HTMLElement>; [attribute: string]: unknown };
    }
  }
}
