/** Numbers as the page's language writes them. */

import { language, localeTag } from "./language";

/** 1100 as "1,100". (In English without Intl, which takes tens of milliseconds of a slow phone to begin.) */
export function count(number: number): string {
  if (language() !== "en") return new Intl.NumberFormat(localeTag(), { maximumFractionDigits: 20 }).format(number);
  const [whole, rest] = String(number).split(".");
  return whole!.replace(/\B(?=(\d{3})+$)/g, ",") + (rest === undefined ? "" : `.${rest}`);
}

/** With so many digits after the point, or what the language has for one. */
export function decimal(number: number, digits: number): string {
  if (language() === "en") return number.toFixed(digits);
  return new Intl.NumberFormat(localeTag(), { minimumFractionDigits: digits, maximumFractionDigits: digits }).format(number);
}

export function percent(share: number): string {
  const whole = Math.round(100 * share);
  return language() === "en" ? `${whole}%` : new Intl.NumberFormat(localeTag(), { style: "percent" }).format(whole / 100);
}

/** Which of the two says it of so many. (The languages of the page tell at most one from others; some have one form, and say the same twice.) */
export function counted(number: number, one: string, other: string): string {
  const isOne = language() === "en" ? number === 1 : new Intl.PluralRules(localeTag()).select(number) === "one";
  return isOne ? one : other;
}

/** "a, b and c". */
export const listed = (items: readonly string[]): string => new Intl.ListFormat(localeTag(), { type: "conjunction" }).format(items);
