#!/usr/bin/env bash
# Question: the header of a palette TGA says that its first stored entry is number 2, and the pixels are 2 and 3. What colours
#   have they?
# Usual guess: those of the first and second stored entry. The TGA text has the field so that only a part of a palette is stored.
# Seen: netpbm 11.01 and (not run here) ImageMagick 6.9.11 draw red and blue. stb_image of 2022-09-08 takes the number for
#   bytes to skip before the palette, and gives cyan at every pixel; three.js r170 does not look at it and gives black. Neither
#   says a word.
# Why it matters: stb_image loads textures for a great many renderers, three.js for web pages: a texture that painting programs
#   show right comes out in one wrong colour, and uv, filter and lights are suspected first.
# Exits 0 if this is still so, 1 if it changed, 2 if the packages cannot be had.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q netpbm=2:11.01.00-2 libnetpbm11=2:11.01.00-2 libstb-dev=0.0~git20220908.8b5f1f3+ds-1 \
    >/dev/null 2>&1 || exit 2
for deb in *.deb; do dpkg -x "$deb" .; done
npm install --silent --no-audit --no-fund three@0.170.0 >/dev/null 2>&1 || exit 2
lib=$PWD/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
# 4 x 2 pixels of 8 bits, the upper row first; two entries of 24 bits (blue, green, red), numbered from 2.
printf '\0\1\1\2\0\2\0\30\0\0\0\0\4\0\2\0\10\40' >p.tga
printf '\0\0\377\377\0\0' >>p.tga
printf '\2\3\2\3\3\2\3\2' >>p.tga
cat >read.c <<'C'
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
int main(void)
{
    int width, height, channels;
    const unsigned char* rgb = stbi_load("p.tga", &width, &height, &channels, 3);
    printf("%d %d %d, %d %d %d\n", rgb[0], rgb[1], rgb[2], rgb[3], rgb[4], rgb[5]);
}
C
gcc -Iusr/include read.c -lm -o read
cat >read.mjs <<'JS'
import { TGALoader } from 'three/examples/jsm/loaders/TGALoader.js';
import { readFileSync } from 'node:fs';
const { data } = new TGALoader().parse(new Uint8Array(readFileSync('p.tga')).buffer);
console.log(`${data.slice(0, 3).join(' ')}, ${data.slice(4, 7).join(' ')}`);
JS
{
    echo "netpbm: $(LD_LIBRARY_PATH=$lib ./usr/bin/tgatoppm -quiet p.tga | tail -c 24 | od -An -tu1 -N6 -w3 | tr -s ' ' |
        sed 's/^ //' | paste -sd, | sed 's/,/, /')"
    echo "stb_image: $(./read)"
    echo "three.js: $(node read.mjs)"
} | tee seen
printf 'netpbm: 255 0 0, 0 0 255\nstb_image: 0 255 255, 0 255 255\nthree.js: 0 0 0, 0 0 0\n' | diff - seen ||
    { echo "This changed."; exit 1; }
