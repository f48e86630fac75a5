# SPDX-License-Identifier: MIT
# Build for Windows with Visual Studio 2022, Qt 6.4 or newer and vcpkg: powershell packaging/windows/build.ps1
# NOT TESTED: Tiller has not been built on Windows yet. The key-state check is not available there, and the
# header shows this.
$ErrorActionPreference = "Stop"
$top = Resolve-Path "$PSScriptRoot/../.."
vcpkg install eigen3 orocos-kdl zlib zstd fastcdr hdf5 sdl2
cmake -S $top -B $top/build/windows -A x64 -DCMAKE_TOOLCHAIN_FILE="$env:VCPKG_ROOT/scripts/buildsystems/vcpkg.cmake" `
    -DTILLER_BUILD_TESTS=OFF -DTILLER_BUILD_BENCHMARKS=OFF -DTILLER_BUILD_PYTHON=OFF -DTILLER_WARNINGS_ARE_ERRORS=OFF
cmake --build $top/build/windows --config Release
cmake --install $top/build/windows --config Release --component application --prefix $top/build/windows/tiller
windeployqt $top/build/windows/tiller/bin/tiller.exe
makensis $top/packaging/windows/tiller.nsi
