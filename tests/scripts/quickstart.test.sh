# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# A clone that is set up but for its images; the program and CSPICE are stand-ins.
make_built_clone() {
    need povray
    make_clone "$PWD/clone"
    make_model clone/input/ldem LDEM_4 IMG LBL
    make_executable clone/scripts/build.sh <<'BUILD'
#!/bin/sh
echo built
BUILD
    make_executable clone/scripts/get-cspice.sh <<'CSPICE'
#!/bin/sh
echo "${CSPICE:-}"
[ -n "${CSPICE:-}" ]
CSPICE
    make_executable clone/publish/msis <<'PROGRAM'
#!/bin/sh
echo "program: $*"
[ -z "$BROKEN" ] || exit 3
[ "$1 $2" != 'fetch albedo' ] || exit 3
[ "$1" != fetch ] || exec test -f input/ldem/LDEM_4.IMG
[ "$1" != ldem ] || exec cp ../made/LDEM_4_SYNTHETIC.IMG ../made/LDEM_4_SYNTHETIC.LBL input/ldem
while [ "$1" != --output-name ]; do shift; done
for file in png xml; do echo made >"output/$2.$file"; done
PROGRAM
    echo x >clone/publish/sources
    touch -t 202001010000 clone/quickstart.sh clone/publish/sources clone/input/ldem/*
}

test_quickstart_renders_three_images_once() {
    make_built_clone
    run clone/quickstart.sh
    assert_code 0
    assert_says 'program: --look photo --camera input/navigation-camera.yaml'
    assert_says 'program: --fixed-state {55289,2E6,2E6,0,'
    assert_says '--renderer native'
    assert_says 'built-in kernel reader'
    assert_says "$PWD/clone/output/thesis-9.2.png"
    CSPICE=/lib/libcspice.so run clone/quickstart.sh
    assert_says 'CSPICE is /lib/libcspice.so.'
    assert_code 0
    assert_silent_on 'program:'
    assert_says "$PWD/clone/output/thesis-9.2.png"
}

test_quickstart_renders_again_after_a_change() {
    make_built_clone
    run clone/quickstart.sh
    touch -t 203001010000 clone/input/ldem/LDEM_4.IMG
    run clone/quickstart.sh
    assert_says 'program: --look photo'
    touch -t 202001010000 clone/input/ldem/LDEM_4.IMG
    rm clone/output/thesis-9.2.xml
    run clone/quickstart.sh
    assert_says 'program: --fixed-state'
    assert_silent_on 'program: --look photo'
}

test_quickstart_failed_rendering_ends_with_the_programs_exit_code() {
    make_built_clone
    BROKEN=yes run clone/quickstart.sh
    assert_code 3
    assert_silent_on 'The images'
}

test_quickstart_without_a_real_model_goes_on_with_a_synthetic_one() {
    make_built_clone
    rm clone/input/ldem/*
    make_model made LDEM_4_SYNTHETIC IMG LBL
    run clone/quickstart.sh
    assert_code 0
    assert_says 'its heights are invented'
    assert_says '--pattern-repos pattern-repository/synthetic/ --res 4'
    assert_says '--renderer native --samples 9 --res 4'
    assert_says '--ldem input/ldem/LDEM_4_SYNTHETIC.LBL --batch'
}
