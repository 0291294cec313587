import { expect, it } from "vitest";
import { Edits } from "./edits";

it("takes back and does again, in order and by name", () => {
  const edits = new Edits(0);
  edits.apply("one", 1);
  edits.apply("two", 2);
  expect([edits.undoes, edits.redoes]).toEqual(["two", null]);
  expect([edits.undo(), edits.undo(), edits.undo()]).toEqual([1, 0, 0]);
  expect([edits.undoes, edits.redoes]).toEqual([null, "one"]);
  expect([edits.redo(), edits.redo(), edits.redo()]).toEqual([1, 2, 2]);
});

it("forgets what was taken back once something else is done", () => {
  const edits = new Edits("a");
  edits.apply("b", "b");
  edits.undo();
  edits.apply("c", "c");
  expect(edits.redoes).toBeNull();
  expect(edits.redo()).toBe("c");
});

it("joins steps of one kind that follow each other closely, and only those", () => {
  const edits = new Edits(0);
  edits.apply("drag", 1, "slider", 1000);
  edits.apply("drag", 2, "slider", 1100);
  expect(edits.undo()).toBe(0);
  edits.apply("drag", 3, "slider", 1200);
  edits.apply("drag", 4, "slider", 9000);
  edits.apply("drag", 5, "other", 9001);
  expect([edits.undo(), edits.undo(), edits.undo()]).toEqual([4, 3, 0]);
});

it("survives random use: undo is the inverse of apply", () => {
  let seed = 7;
  const random = (n: number): number => (seed = (seed * 16807) % 2147483647) % n;
  const edits = new Edits(0);
  let past = [0];
  let future: number[] = [];
  for (let i = 1; i < 2000; i++) {
    const what = random(4);
    if (what < 2) {
      edits.apply("x", i);
      past = [...past, i].slice(-201);
      future = [];
    } else if (what === 2) {
      edits.undo();
      if (past.length > 1) future.push(past.pop()!);
    } else {
      edits.redo();
      if (future.length) past.push(future.pop()!);
    }
    expect(edits.present).toBe(past.at(-1));
  }
});

it("changes every step at once for what nobody did", () => {
  const edits = new Edits({ mine: 0, example: "" });
  edits.apply("one", { ...edits.present, mine: 1 });
  edits.apply("two", { ...edits.present, mine: 2 });
  edits.undo();
  edits.amend((value) => ({ ...value, example: "cat" }));
  expect([edits.present, edits.undo(), edits.redo(), edits.redo()]).toEqual([1, 0, 1, 2].map((mine) => ({ mine, example: "cat" })));
});
