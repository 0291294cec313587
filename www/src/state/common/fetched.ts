/** A file of the page's own. */
export async function fetched(url: string): Promise<Response> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response;
}

/** A share code in such a file. */
export async function codeAt(url: string): Promise<string> {
  return (await (await fetched(url)).text()).trim();
}
