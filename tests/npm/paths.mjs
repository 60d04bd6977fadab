// Names of files of Windows, on any system.
import { join, posix, win32 } from "node:path";
import { pathToFileURL } from "node:url";

export async function tryPaths({ check, home }) {
  const { diskPath, engineFolder, enginePath } = await import(pathToFileURL(join(home, "command/paths.mjs")));
  const is = (found, wanted) => check(found === wanted, `${found} is not ${wanted}`);
  is(enginePath("C:\\My pads\\drop.toml", win32), "C:/My pads/drop.toml");
  is(enginePath("..\\drop.toml", win32), "../drop.toml");
  is(enginePath("odd\\name.toml", posix), "odd\\name.toml");
  is(engineFolder("C:\\My pads\\cards\\", win32), "C:/My pads/cards");
  is(engineFolder("cards//", posix), "cards");
  is(engineFolder("C:\\", win32), "C:/");
  is(engineFolder("/", posix), "/");

  // What the engine makes of C:/My pads/drop.toml and a name in it.
  const looked_for = (name) => diskPath(`C:/My pads/${name}`, win32);
  is(looked_for("foam.toml"), "C:\\My pads\\foam.toml");
  is(looked_for("..\\cards\\foam.toml"), "C:\\cards\\foam.toml");
  is(looked_for("D:\\cards\\foam.toml"), "D:\\cards\\foam.toml");
  is(looked_for("D:/cards/foam.toml"), "D:\\cards\\foam.toml");
  is(looked_for("\\\\server\\pads\\foam.toml"), "\\\\server\\pads\\foam.toml");
  is(diskPath("foam.toml", win32), "foam.toml");
  is(diskPath("//server/pads/foam.toml", win32), "\\\\server\\pads\\foam.toml");
  is(diskPath("pads/D:\\foam.toml", posix), "pads/D:\\foam.toml");
}
