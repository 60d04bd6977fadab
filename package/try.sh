#!/bin/sh
# Tries an installed dashpad where nothing else is: try.sh DASHPAD SHARE, with SHARE its share/dashpad.
set -eu
dashpad="$1" share="$2"
cd "$(mktemp -d)"

"$dashpad" run "$share/examples/helmet-pad-10fps.toml" --report page.html --png picture.png --csv history.csv >run.txt
grep -q "^  HIC15 " run.txt
grep -q "</html>" page.html
"$dashpad" assess "$share/examples/helmet-pad-10fps.toml" --standard en-1078 >assess.txt
grep -q "^Passes" assess.txt

cat >study.toml <<TEXT
case = "$share/examples/helmet-pad-10fps.toml"
responses = ["hic15"]
[factors."pad.thickness"]
values = ["40 mm", "45 mm", "50 mm"]
TEXT
"$dashpad" study study.toml --out study.db --quiet >study.txt
test "$("$dashpad" study export study.db --csv - 2>/dev/null | wc -l)" -eq 4
"$dashpad" study export study.db --hdf5 study.h5 >/dev/null
"$dashpad" export "$share/examples/helmet-pad-10fps.toml" --format iso-mme --out test.zip >/dev/null
"$dashpad" pulse test.zip --list >/dev/null
"$dashpad" explore "$share/examples/helmet-pad-10fps.toml" --out live.html >/dev/null
sed -n 1p run.txt
cat study.txt
wc -c page.html picture.png study.h5 test.zip live.html
