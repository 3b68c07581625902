# shellcheck shell=bash
# shellcheck disable=SC2154 # sysroot.sh sets sysroot
# Sourced after dotnet.sh and sysroot.sh: lets .NET make the program, in each of its kinds, in a folder.

# publish_program PROJECT FOLDER ARGUMENTS...: the analysers judge the sources in test.sh's build.
publish_program() {
    seldom_collecting dotnet publish "src/$1" -c Release -p:RunAnalyzers=false "${@:3}" -o "$2" -v quiet -nologo ||
        die 'the build failed; the messages above say why. What was built before is as it was.'
}

# publish_native SYSTEM FOLDER LEVEL...: a program for each level of processors, under its name; msis is the one that runs on most.
# ./msis chooses.
publish_native() {
    local system=$1 folder=$2 level cross=()
    install_parts compiler cmake static-openssl || die '--native needs them: install them, or run scripts/build.sh --dotnet.'
    if [ "$system" != linux-x64 ]; then
        prepare_sysroot "$system"
        export CMAKE_TOOLCHAIN_FILE=$sysroot/toolchain.cmake
        cross=(-p:SysRoot="$sysroot" -p:CppCompilerAndLinker=clang -p:LinkerFlavor=lld -p:ObjCopyName=aarch64-linux-gnu-objcopy)
    fi
    for level in "${@:3}"; do
        publish_program Msisf.Native "$folder/$level" -r "$system" -p:Native=true -p:IlcInstructionSet="$level" "${cross[@]}"
        mv "$folder/$level/msisf" "$folder/msis-$level"
        [ -e "$folder/wwwroot" ] || mv "$folder/$level"/{*.so,wwwroot} "$folder"
        rm -r "${folder:?}/$level"
    done
    ln -s "msis-$3" "$folder/msis"
}

# publish_with_jit SYSTEM FOLDER: the same one program, with the parts of .NET that it needs beside it; for any system without them.
publish_with_jit() {
    local end='' target=(-r "$1" -p:WithJit=true)
    [[ $1 != win-* ]] || end=.exe
    [ "$1" != any ] || target=(--no-self-contained)
    publish_program Msisf.Native "$2" "${target[@]}"
    mv "$2/msisf$end" "$2/msis$end"
    rm -f "$2"/msis-server{,.exe} "$2"/msis{,-server}.runtimeconfig.json "$2"/{createdump*,*.xml}
    find "$2" -name '*.pdb' -delete
    if [ "$1" = any ]; then
        rm -r "$2/msis" "$2"/runtimes/linux-{*bionic,*riscv64,*loongarch64,x86}* # the program of this system; systems that .NET does not run on
    fi
}

# publish_on_dotnet FOLDER: with .NET's own package for this system beside it the program brings .NET along, and its first image needs two
# thirds of the time. The server is in a folder of its own, with libraries of its own: those of msis fit the .NET that it brings along, and
# the server runs on that of the machine.
publish_on_dotnet() {
    local target=(-p:PublishReadyToRun=false)
    if [ "$(uname -s)-$(uname -m)" = Linux-x86_64 ]; then # the one system whose compiler package the lock files name
        target=(-r linux-x64 -p:WithFramework=true)
        if ! dotnet restore src/Msisf.Cli "${target[@]}" -v quiet -nologo >/dev/null 2>&1; then
            say 'The package of the .NET runtime is not to be had here: msis uses the .NET of this machine and starts more slowly.'
            target=(-r linux-x64)
        fi
    fi
    publish_program Msisf.Cli "$1" "${target[@]}"
    publish_program Msisf.Server "$1/server" -p:PublishReadyToRun=false "${target[@]:0:2}"
}
