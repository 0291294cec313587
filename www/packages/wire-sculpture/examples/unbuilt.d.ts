/** Where the package has not been built, its own types are not there. */
declare module "wire-sculpture";
