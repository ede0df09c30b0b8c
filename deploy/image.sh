#!/bin/sh
# Build the image without Docker and run its health check: needs root, buildah and debootstrap.
# BASE_IMAGE: a base with Python 3.11 as `python`; made of Debian where it is not given.
# BUILD_OPTIONS: more options of `buildah bud`, such as --volume for pip's configuration.
set -eu
cd "$(dirname "$0")/.."
place=$(mktemp -d)
service= base= container=
export BUILDAH_ISOLATION=chroot STORAGE_DRIVER=vfs
end() {
    [ -z "$service" ] || kill "$service" 2>/dev/null || true
    for each in $base $container; do buildah rm "$each" >/dev/null 2>&1 || true; done
    rm -rf "$place"
}
trap end EXIT

if [ -z "${BASE_IMAGE:-}" ]; then
    BASE_IMAGE=localhost/khv-base
    if ! buildah inspect --type image "$BASE_IMAGE" >/dev/null 2>&1; then
        debootstrap --variant=minbase \
            --include=python3-venv,python-is-python3,ca-certificates bookworm "$place/base"
        rm -rf "$place"/base/var/cache/apt/* "$place"/base/var/lib/apt/lists/*
        base=$(buildah from scratch)
        buildah add --quiet "$base" "$place/base" /
        buildah commit --quiet "$base" "$BASE_IMAGE"
    fi
fi

# shellcheck disable=SC2086
buildah bud --isolation chroot --format docker --build-arg BASE_IMAGE="$BASE_IMAGE" \
    --build-arg BUILD="${BUILD:-}" ${BUILD_OPTIONS:-} --tag khv-calc .

container=$(buildah from khv-calc)
buildah run "$container" -- python -m app.serve >"$place/log" 2>&1 &
service=$!
check=$(buildah inspect --type image --format '{{index .Docker.Config.Healthcheck.Test 3}}' khv-calc)
for _ in $(seq 60); do
    if buildah run "$container" -- python -c "$check" 2>/dev/null; then
        echo "healthy"
        buildah run "$container" -- du -sm /packages /service / 2>/dev/null || true
        exit
    fi
    sleep 1
done
cat "$place/log"
echo "not healthy within a minute"
exit 1
