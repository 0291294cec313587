/** Measured figures of a lesson. */

import { html, type TemplateResult } from "lit";
import type { Table } from "../../state/lesson/lesson";

export function figuresTable({ columns, rows }: Table, text: (key: string) => string): TemplateResult {
  const figure = new Intl.NumberFormat(document.documentElement.lang, { maximumFractionDigits: 2 });
  return html`<table>
    <caption>${text("table")}</caption>
    <thead>
      <tr><td></td>${columns.map((column) => html`<th scope="col">${text(`column.${column}`)}</th>`)}</tr>
    </thead>
    <tbody>
      ${rows.map(({ id, values }) => html`<tr><th scope="row">${text(`row.${id}`)}</th>${values.map((value) => html`<td>${figure.format(value)}</td>`)}</tr>`)}
    </tbody>
  </table>`;
}
