/** Readers of data that somebody wrote by hand: each takes any value and where it stands, and gives what it should be. */

import { msg, str } from "@lit/localize";

/** What is wrong with it, a sentence for people. */
export class Fault extends Error {}

export type Reader<T> = (value: unknown, at: string) => T;
type Read<Readers> = { readonly [Name in keyof Readers]: Readers[Name] extends Reader<infer T> ? T : never };

function refuse(at: string, wanted: string): never {
  throw new Fault(msg(str`“${at}” should be ${wanted}.`));
}

export const text: Reader<string> = (value, at) => (typeof value === "string" && value !== "" ? value : refuse(at, msg("a text")));

/** A name in keys and addresses. */
export const name: Reader<string> = (value, at) => (typeof value === "string" && /^[a-z0-9-]+$/.test(value) ? value : refuse(at, msg("a name of small letters, digits and hyphens")));

export const number: Reader<number> = (value, at) => (typeof value === "number" && Number.isFinite(value) ? value : refuse(at, msg("a number")));

export const yes: Reader<true> = (value, at) => (value === true ? true : refuse(at, msg("true, or left out")));

export function oneOf<const Word extends string>(words: readonly Word[]): Reader<Word> {
  return (value, at) => words.find((word) => word === value) ?? refuse(at, msg(str`one of ${words.join(", ")}`));
}

export function list<T>(reader: Reader<T>, least = 0): Reader<readonly T[]> {
  return (value, at) => (Array.isArray(value) && value.length >= least ? value.map((item, i) => reader(item, `${at} ${i + 1}`)) : refuse(at, least ? msg(str`a list of at least ${least}`) : msg("a list")));
}

export function pairs<T>(reader: Reader<T>): Reader<Readonly<Record<string, T>>> {
  return (value, at) => Object.fromEntries(Object.entries(object(value, at)).map(([key, item]) => [key, reader(item, `${at}: ${key}`)]));
}

/** An object with these fields, perhaps those, and no others. */
export function fields<Needed extends Record<string, Reader<unknown>>, May extends Record<string, Reader<unknown>>>(needed: Needed, may: May): Reader<Read<Needed> & Partial<Read<May>>> {
  return (value, at) => {
    const given = object(value, at);
    const stray = Object.keys(given).find((key) => !(key in needed) && !(key in may));
    if (stray !== undefined) throw new Fault(msg(str`“${at}” has “${stray}”, which is not known here.`));
    const asked = Object.entries({ ...may, ...needed }).filter(([key]) => key in needed || key in given);
    return Object.fromEntries(asked.map(([key, reader]) => [key, reader(given[key], `${at}: ${key}`)])) as Read<Needed> & Partial<Read<May>>;
  };
}

function object(value: unknown, at: string): Readonly<Record<string, unknown>> {
  return typeof value === "object" && value !== null && !Array.isArray(value) ? (value as Readonly<Record<string, unknown>>) : refuse(at, msg("an object"));
}
