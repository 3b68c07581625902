using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>
/// The table of wrong inputs: each ends with its exit code and with one line that says what is wrong and where, without a
/// stack trace and without an output.
/// </summary>
public sealed class WrongInputTests : IDisposable
{
    private const string Fixed = "--fixed-state {55289,2E6,2E6,0,0,0,3.826834323650898E-1,9.238795325112867E-1}";
    private const string Kepler = "--kepler-set {1.9E6,0,0,0,1,0}";
    private const string Orbit = $"{Kepler} --epoch 55289";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]

    // The command line itself.
    [InlineData("--widht 5", 1, "--widht")]
    [InlineData("render", 1, "'render' is not a command. See msis --help.")]
    [InlineData("statsu a", 1, "'statsu' is not a command: did you mean states? See msis --help.")]
    [InlineData("ldem synthesise", 1, "'synthesise' is not a command: did you mean synthesize? See msis ldem --help.")]
    [InlineData("--rendrer native", 1, "--rendrer is not an option: did you mean --renderer? See msis --help.")]
    [InlineData("--rendrer=native", 1, "--rendrer is not an option: did you mean --renderer?")]
    [InlineData("status a --fov 3", 1, "--fov is not an option. See msis status --help.")]
    [InlineData($"{Fixed} --renderer nativ", 1, "--renderer is 'nativ'; one of povray, native is needed: did you mean native?")]
    [InlineData($"{Fixed} --renderer native --layers dpeth", 1, "--layers dpeth: 'dpeth' is not a layer: did you mean depth?")]
    [InlineData($"{Fixed} --renderer native --reflectance lambrt", 1, "'lambrt' is not a law: did you mean lambert?")]
    [InlineData("--batch", 1, "nothing says where the camera is")]
    [InlineData("--width", 1, "--width")]
    [InlineData($"{Fixed} --width 5 --width 6", 1, "--width is given 2 times. Give it once. See msis --help.")]
    [InlineData("--times=55289 --times=55290 --times=55291", 1, "--times is given 3 times. Give it once, and quote a value in braces")]
    [InlineData($"{Fixed} --fixed-state {{55289,2E6,2E6,0,0,0,0,1}}", 1, "--fixed-state is given 2 times")]
    [InlineData("--batch patterns --res 4", 1, "--batch comes before the command patterns")]
    [InlineData("@missing.rsp", 1, "missing.rsp")]
    [InlineData("@.", 1, "can't be read")]
    [InlineData($"{Fixed} --widht 5", 1, "--widht is not an option: did you mean --width? It comes where the value of --fixed-state ends.")]
    [InlineData($"{Kepler} -x 5", 1, "-x is not an option. It comes where the value of --kepler-set ends.")]
    [InlineData("ldem", 1, "msis ldem --help")]
    [InlineData("ldem pyramid", 1, "pyramid needs a model: give its label, or --res")]
    [InlineData("ldem pyramid .", 1, "pyramid needs a model: give its label, or --res")]
    [InlineData("ldem pyramid ", 1, "The model's name is empty")]
    [InlineData("ldem pyramid missing.lbl", 2, "missing.lbl: there is no such file or folder.")]
    [InlineData("ldem pyramid --res 1025", 1, "--res is '1025'")]

    // Cameras that scan.
    [InlineData($"{Fixed} --lines 4", 1, "--lines needs a camera that scans: one whose file has the section 'scan'.")]
    [InlineData(
        $"{Fixed} --renderer native --camera lroc-nac-l --lines 4", 1,
        "nothing says how the camera moves while it scans. Give --traj")]
    [InlineData($"{Orbit} --time 55289 --renderer native --camera lroc-nac-l --lines 0", 1, "--lines is '0'; a whole number from 1")]
    [InlineData(
        $"{Orbit} --time 55289 --renderer native --camera lroc-nac-l --framelets 4", 1,
        "no meaning for --camera lroc-nac-l. Give --lines")]
    [InlineData(
        $"{Orbit} --time 55289 --renderer native --camera lroc-nac-l --lines 4 --framelets 4", 1,
        "--framelets has no meaning for --camera lroc-nac-l. Leave it out.")]
    [InlineData(
        $"{Orbit} --time 55289 --renderer native --camera lroc-wac-643 --lines 4 --framelets 4", 1,
        "--lines has no meaning for --camera lroc-wac-643. Leave it out.")]
    [InlineData($"{Orbit} --time 55289 --renderer native --camera lroc-nac-l --scan-period 1", 1, "--scan-period needs --lines: how many.")]
    [InlineData(
        $"{Orbit} --time 55289 --renderer native --camera lroc-wac-643 --lines 4", 1,
        "for --camera lroc-wac-643. Give --framelets")]
    [InlineData($"{Orbit} --time 55289 --jitter missing.txt", 2, "--jitter missing.txt: there is no such file.")]
    [InlineData($"{Orbit} --time 55289 --jitter .", 2, "--jitter .: is a folder; a file of jitter is needed.")]
    [InlineData("--trajectory missing.txt", 2, "--trajectory missing.txt: there is no such file.")]
    [InlineData("--trajectory a --epoch 55289 --attitude {0,0,0,1}", 1, "--attitude is not allowed with --trajectory, whose file says how")]
    [InlineData("--trajectory -", 1, "--trajectory can't be read from standard input. Save the states to a file.")]
    [InlineData(
        $"{Fixed} --trajectory-attitudes squad", 1,
        "--trajectory-attitudes is not allowed with --fixed-state, but with --trajectory only")]

    // Table 6.1: which argument goes with which mode.
    [InlineData($"{Fixed} {Kepler}", 1, "exclude each other")]
    [InlineData($"{Fixed} --batch-file a.tab", 1, "exclude each other")]
    [InlineData($"{Kepler} --state-vectors {{1,2,3,4,5,6}}", 1, "exclude each other")]
    [InlineData($"{Fixed} --epoch 55289", 1, "--epoch is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --time 55289", 1, "--time is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --times {{55289}}", 1, "--times is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --time-interval [1:1:2]", 1, "--time-interval is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --attitude {{0,0,0,1}}", 1, "--attitude is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --attitude-transition {{0,0,0}}", 1, "--attitude-transition is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --orbit-frame j2000", 1, "--orbit-frame is not allowed with --fixed-state")]
    [InlineData($"{Fixed} --batch-frame j2000", 1, "--batch-frame is not allowed with --fixed-state, but with --batch-file only")]
    [InlineData($"{Fixed} --ignore-columns", 1, "--ignore-columns is not allowed with --fixed-state, but with --batch-file only")]
    [InlineData("--position 1,2,3E4 --time 55289 --normalize", 1, "--normalize has no meaning: nothing gives a quaternion")]
    [InlineData($"{Orbit} --time 55289 --normalize", 1, "--normalize has no meaning: nothing gives a quaternion")]
    [InlineData("--batch-file a.tab --batch-euler zyx", 1, "--batch-euler: 'zyx' in small letters means turns about axes at rest")]
    [InlineData("--batch-file a.tab --batch-axes cv", 1, "--batch-axes is 'cv'; one of camera, opencv is needed")]
    [InlineData(
        "--fixed-state {55289,2E6,0,0,0.35355,0.35355,0.61237,0.61237}", 1,
        "a rotation needs length 1 within 1E-06: write each number with at least 7 decimals, or give --normalize.")]
    [InlineData("--fixed-state {55289,2E6,0,0,0,0,0,0.9}", 1, "rounding does not explain it; check the numbers and their order.")]
    [InlineData("--fixed-state {55289,2E6,0,0,0,0,0,0.9} --normalize", 1, "rounding does not explain it")]
    [InlineData("--batch-file a.tab --time 55289", 1, "--time is not allowed with --batch-file")]
    [InlineData("--batch-file a.tab --attitude {0,0,0,1}", 1, "--attitude is not allowed with --batch-file")]
    [InlineData($"{Kepler} --time 55289", 1, "--kepler-set needs --epoch")]
    [InlineData(Orbit, 1, "--kepler-set needs one of --time, --times, --time-interval")]
    [InlineData($"{Orbit} --time 55289 --times {{55289}}", 1, "--time and --times exclude each other")]
    [InlineData($"{Orbit} --time 55289 --time-interval [1:1:2]", 1, "--time and --time-interval exclude each other")]
    [InlineData($"{Orbit} --time 55289 --attitude-transition {{0,0,1}}", 1, "--attitude-transition needs --attitude")]
    [InlineData("--state-vectors {1.9E6,0,0,0,1600,0} --time 55289", 1, "--state-vectors needs --epoch")]

    // A camera by its place.
    [InlineData("--position 1,2,3E4", 1, "--position needs one of --time, --times, --time-interval")]
    [InlineData($"--position 1,2,3E4 {Fixed}", 1, "exclude each other")]
    [InlineData("--position 1,2,3E4 --time 55289 --epoch 55289", 1, "--epoch is not allowed with --position")]
    [InlineData("--position 1,2,3E4 --time 55289 --attitude {0,0,0,1}", 1, "--attitude is not allowed with --position")]
    [InlineData("--position 1,2,3E4 --time 55289 --look-at nadir --off-nadir 5", 1, "--look-at and --off-nadir exclude each other")]
    [InlineData($"{Fixed} --look-at 1,2", 1, "--look-at is not allowed with --fixed-state, but with --position only")]
    [InlineData($"{Orbit} --time 55289 --roll 5", 1, "--roll is not allowed with --kepler-set")]
    [InlineData("--batch-file a.tab --off-nadir 5", 1, "--off-nadir is not allowed with --batch-file")]
    [InlineData("--position 1,2 --time 55289", 1, "--position: '1,2' has 2 parts; LAT,LON,HEIGHT or NAME,HEIGHT is needed")]
    [InlineData("--position 100,2,3E4 --time 55289", 1, "latitude and longitude swapped?")]
    [InlineData("--position -1,2,3E4 --time 55289 --look-at moon", 1, "--look-at: 'moon' is nothing to look at")]
    [InlineData("--position 1,2,3E4 --time 55289 --off-nadir 200", 1, "--off-nadir: The angle from the nadir")]
    [InlineData("--position 1,2,3E4 --time 55289 --up left", 1, "zenith, north, sun")]
    [InlineData("--position 1,2,3E4 --time 55289 --roll left", 1, "--roll: 'left' is not a number")]

    // Times.
    [InlineData($"{Orbit} --time 2455289.5", 1, "--time: '2455289.5' looks like a Julian Date; its MJD is 55289 (")]
    [InlineData($"{Orbit} --time 2017-12-31T23:59:60Z", 2, "2017-12-31T23:59:60: there was no leap second then")]
    [InlineData($"{Kepler} --epoch 2016-12-31 --time 55289", 1, "--epoch: '2016-12-31' has no time of day; write e.g. 2016-12-31T00")]
    [InlineData("--fixed-state {2455289.5,2E6,2E6,0,0,0,0,1}", 1, "number 1 (MJD): '2455289.5' looks like a Julian Date")]
    [InlineData($"{Orbit} --times {{55289,2016-12-31T12:00:00}}", 1, "number 2 (MJD2): '2016-12-31T12:00:00' has no time zone")]

    // Frames.
    [InlineData($"{Orbit} --time 55289 --attitude-frame lvlh", 1, "--attitude-frame needs --attitude")]
    [InlineData($"{Fixed} --attitude-frame lvlh", 1, "--attitude-frame is not allowed with --fixed-state")]
    [InlineData($"{Orbit} --time 55289 --attitude {{0,0,0,1}} --attitude-frame vvlh", 1, "moon-me, moon-me-epoch, j2000, lvlh")]

    // Single values.
    [InlineData($"{Fixed} --width 0", 1, "--width is '0'")]
    [InlineData($"{Fixed} --width -5", 1, "--width is '-5'")]
    [InlineData($"{Fixed} --width 16385", 1, "from 1 to 16384")]
    [InlineData($"{Fixed} --height 1.5", 1, "--height is '1.5'")]
    [InlineData($"{Fixed} --height abc", 1, "--height is 'abc'")]
    [InlineData($"{Fixed} --width 99999999999999999999", 1, "--width")]
    [InlineData($"{Fixed} --fov 0", 1, "--fov is 0")]
    [InlineData($"{Fixed} --fov 180", 1, "--fov is 180")]
    [InlineData($"{Fixed} --fov NaN", 1, "'NaN' is not finite")]
    [InlineData($"{Fixed} --fov 40,5", 1, "'40,5' has a comma")]
    [InlineData($"{Fixed} --grid 0", 1, "--grid is '0'")]
    [InlineData($"{Fixed} --gridH -1", 1, "--gridH is '-1'")]
    [InlineData($"{Fixed} --gridV x", 1, "--gridV is 'x'")]
    [InlineData($"{Fixed} --surface moon", 1, "--surface is 'moon'; one of sphere, terrain is needed")]
    [InlineData($"{Fixed} --res 0", 1, "--res is '0'")]
    [InlineData($"{Fixed} --res 4.0", 1, "--res is '4.0'")]
    [InlineData($"{Fixed} --res 5000", 1, "from 1 to 1024")]
    [InlineData($"{Fixed} --ephemeris jpl", 1, "cspice, builtin, auto")]
    [InlineData($"{Fixed} --aberration cn", 1, "--aberration is 'cn'; one of none, lt, lt+s is needed")]
    [InlineData($"{Fixed} --aberration lt --ignore-sun", 1, "--aberration has no meaning with --ignore-sun")]
    [InlineData($"{Orbit} --time 55289 --orbit-frame icrf", 1, "moon-me, moon-me-epoch, j2000")]
    [InlineData($"{Fixed} --timeout 0", 1, "--timeout is 0")]
    [InlineData($"{Fixed} --timeout soon", 1, "'soon' is not a number")]
    [InlineData($"{Fixed} --jobs 0", 1, "--jobs is '0'")]
    [InlineData($"{Fixed} --pov-options +W64", 1, "+W64 is set by msis itself")]
    [InlineData($"{Fixed} --pov-options +SC0.5", 1, "+SC0.5 is set by msis itself")]
    [InlineData($"{Fixed} --pov-options +KFF3", 1, "+KFF3 is set by msis itself")]
    [InlineData($"{Fixed} --pov-options -J --fov 0", 1, "--fov is 0")]
    [InlineData($"{Fixed} --ldem -b", 1, "It comes where the value of --ldem ends.")]
    [InlineData($"{Fixed} --pov-options fast", 1, "'fast' is not a POV-Ray option")]
    [InlineData($"{Fixed} --output-name sub/name", 1, "without folders")]
    [InlineData($"{Fixed} --output-name {{frame}}", 1, "a field is {step} or {mjd}")]
    [InlineData($"{Fixed} --output-name {{step", 1, "a field is {step} or {mjd}")]
    [InlineData($"{Orbit} --times {{55289,55290}} --output-name same", 1, "steps 1 and 2 would both be written to same")]

    // Values in braces.
    [InlineData("--fixed-state {55289,2E10,2E6,0,0,0,0,1} --ephemeris builtin", 2, "POV-Ray draws nothing beyond 1E+010 m")]
    [InlineData("--fixed-state {55289,0,0,0,0,0,0,1} --ephemeris builtin", 2, "at the Moon's centre")]
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,1}", 1, "7 numbers, 8 expected")]
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,0,1,0}", 1, "9 numbers, 8 expected")]
    [InlineData("--fixed-state {55289,2E6,,0,0,0,0,1}", 1, "a number is missing")]
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,0,1", 1, "unbalanced")]
    [InlineData("--fixed-state {55289,2E6,abc,0,0,0,0,1}", 1, "number 3 (ry): 'abc' is not a number")]
    [InlineData("--fixed-state {55289,2E6,1e999,0,0,0,0,1}", 1, "too large")]
    [InlineData("--fixed-state {55289,2E6,Infinity,0,0,0,0,1}", 1, "not finite")]
    [InlineData("--fixed-state {55289,2E6,0x10,0,0,0,0,1}", 1, "hexadecimal")]
    [InlineData("--fixed-state {1e9,2E6,0,0,0,0,0,1}", 1, "is not a date")]
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,0,0}", 1, "a rotation needs length 1")]
    [InlineData("--fixed-state {55289,2E6,2E6,0,0,0,0,1.00001}", 1, "a rotation needs length 1")]
    [InlineData("--kepler-set {-1.9E6,0,0,0,1,0} --epoch 55289 --time 55289", 1, "semi-major axis")]
    [InlineData("--kepler-set {1.9E6,-0.1,0,0,1,0} --epoch 55289 --time 55289", 1, "eccentricity")]
    [InlineData("--kepler-set {1.9E6,1,0,0,1,0} --epoch 55289 --time 55289", 1, "eccentricity")]
    [InlineData("--kepler-set {1.9E6,0,0,0,1} --epoch 55289 --time 55289", 1, "5 numbers, 6 expected")]
    [InlineData("--state-vectors {1.9E6,0,0,0,9000,0} --epoch 55289 --time 55289", 1, "--state-vectors: ")]
    [InlineData("--state-vectors {0,0,0,0,1600,0} --epoch 55289 --time 55289", 1, "--state-vectors: ")]
    [InlineData("--state-vectors {1.9E6,0,0,1600,0,0} --epoch 55289 --time 55289", 1, "--state-vectors: ")]
    [InlineData($"{Kepler} --epoch x --time 55289", 1, "--epoch: 'x' is not a number")]
    [InlineData($"{Kepler} --epoch 1e9 --time 55289", 1, "--epoch: ")]
    [InlineData($"{Orbit} --time 1e9", 1, "--time: ")]
    [InlineData($"{Orbit} --times {{}}", 1, "the list is empty")]
    [InlineData($"{Orbit} --times {{55289,x}}", 1, "number 2 (MJD2): 'x' is not a number")]
    [InlineData($"{Orbit} --time-interval [55289:55290]", 1, "2 numbers, 3 expected")]
    [InlineData($"{Orbit} --time-interval [55289:0:55290]", 1, "step")]
    [InlineData($"{Orbit} --time-interval [55289:1e-9:55290]", 1, "at most")]
    [InlineData($"{Orbit} --time-interval [55290:1:55289]", 4, "no time in it")]
    [InlineData($"{Orbit} --time 55289 --attitude {{0,0,0,2}}", 1, "--attitude: ")]
    [InlineData($"{Orbit} --time 55289 --attitude {{0,0,0,1}} --attitude-transition {{1,2}}", 1, "2 numbers, 3 expected")]

    // Files and external parts.
    [InlineData("--batch-file missing.tab", 2, "missing.tab: there is no such file")]
    [InlineData("--batch-file .", 2, "is a folder")]
    [InlineData($"{Fixed} --kernels missing.tm", 2, "missing.tm")]
    [InlineData($"{Fixed} --ldem missing.lbl --ephemeris builtin", 2, "missing.lbl")]
    [InlineData("--fixed-state {10000,2E6,2E6,0,0,0,0,1} --ephemeris builtin", 3, "cover")]
    [InlineData("patterns --res x", 1, "--res is 'x'")]
    [InlineData("patterns --fov 3", 1, "--fov is for the patterns of a run only. Say of which by --for-batch")]
    [InlineData("patterns --frames 1:2", 1, "--frames is for the patterns of a run only")]
    [InlineData("patterns --for-batch missing.tab", 2, "--for-batch missing.tab: there is no such file")]
    [InlineData("patterns --for-batch a.tab --margin 0.5", 1, "--margin has no meaning for the patterns of a run")]
    [InlineData("patterns --for-batch a.tab --source mysql", 1, "--source has no meaning for the patterns of a run")]
    [InlineData($"patterns --for-batch a.tab {Kepler}", 1, "--kepler-set and --for-batch exclude each other")]
    [InlineData("patterns --for-batch a.tab --fov 0", 1, "--fov is 0")]
    [InlineData("patterns --margin -1", 1, "--margin")]
    [InlineData("patterns --format obj", 1, "--format")]
    [InlineData("patterns --source sqlite", 1, "--source is 'sqlite'; one of ldem, mysql")]
    [InlineData("patterns --source mysql", 1, "no database user")]
    [InlineData("patterns --source mysql --ldem missing.lbl", 1, "--ldem and --source mysql contradict each other")]
    [InlineData("patterns --source mysql --defaults-file missing.cnf", 2, "missing.cnf")]
    [InlineData("patterns --defaults-file missing.cnf", 1, "--source mysql only")]
    [InlineData("ldem synthesize", 1, "--seed")]
    [InlineData("ldem synthesize --seed 1", 1, "--res is required")]
    [InlineData("ldem synthesize --seed 1 --projection polar-south", 1, "--map-scale is required for a polar map")]
    [InlineData("ldem synthesize --seed 1 --projection polar-south --map-scale 100 --res 4", 1, "--res is for models of latitude")]
    [InlineData("ldem synthesize --seed 1 --projection polar-north --map-scale 100 --region 0:1:0:1", 1, "--region is for models of")]
    [InlineData("ldem synthesize --seed 1 --res 4 --map-scale 100", 1, "--map-scale is for polar maps")]
    [InlineData("ldem synthesize --seed 1 --res 4 --latitude 80", 1, "--latitude is for polar maps")]
    [InlineData(
        "ldem synthesize --seed 1 --projection polar --map-scale 100", 1,
        "--projection is 'polar'; one of cylindrical, polar-south")]
    [InlineData("ldem synthesize --seed 1 --projection polar-south --map-scale 30000 --latitude 89.9", 2, "has no samples at 30000 m/px")]
    [InlineData("ldem synthesize --res 4", 1, "--seed")]
    [InlineData("ldem synthesize --res 0 --seed 1", 1, "--res is '0'")]
    [InlineData("ldem synthesize --res 4 --seed x", 1, "--seed is 'x'")]
    [InlineData("ldem synthesize --res 4 --seed 1 --region 1:2", 1, "error: --region 1:2: ")]
    public void Run_WrongArguments_EndWithCodeAndOneLine(string words, int exitCode, string message) =>
        RefusedRun.Check(_folder, words.Split(' '), exitCode, message);

    [Fact]
    public void Run_MisspeltOptionInPlaceOfAFolder_IsNotTakenForOne()
    {
        CommandLineRun run = CommandLineRun.Of(["status", "--print-frams"]);

        Assert.Equal(1, run.ExitCode);
        Assert.Equal("msis: error: --print-frams is not an option: did you mean --print-frames?\n", run.Error);
    }

    [RequiresTheory(Part.Ldem4)]
    [InlineData($"{Fixed} --pov-path missing-folder", 3, "missing-folder")]
    [InlineData("--fixed-state {55289,1.7E6,0,0,0,0,0,1}", 2, "the camera is inside the Moon")]
    [InlineData("--fixed-state {55289,0,0,-1.7E6,0,0,0,1} --list-patterns", 2, "the camera is inside the Moon")]
    [InlineData("--fixed-state {55289,0,0,-1837,0,0,0,1}", 2, "1837 from the centre looks like kilometres")]
    [InlineData("--position 10,20,terrain-1 --time 55289", 2, "by 1.0 m. Choose positions above the terrain.")]
    public void Run_WrongArgumentsThatTheModelShows_EndWithCodeAndOneLine(string words, int exitCode, string message) =>
        RefusedRun.Check(_folder, [.. words.Split(' '), "--ephemeris", "builtin", "--ldem", TestParts.Ldem4Label!], exitCode, message);

    [Theory]
    [InlineData("55289 2E6 2E6 0 0 0 0", 2, "standard input, line 1", "7 numbers, 8 expected")]
    [InlineData("# comment\n\n55289 2E6 2E6 0 0 0 x 1", 2, "line 3, column 21", "'x' is not a number")]
    [InlineData("55289 2E6 2E6 0 0 0 0 1 2", 2, "line 1", "9 numbers, 8 expected")]
    [InlineData("55289 2E6 2E6 0 0 0 0 1\n55289 2E6 2E6 0 0 0 0 2", 2, "line 2", "length 1")]
    [InlineData("55289 NaN 2E6 0 0 0 0 1", 2, "line 1", "'NaN' is not finite")]
    [InlineData("time,lat,lon,hight\n1,2,3,4", 2, "standard input, line 1", "did you mean height?")]
    [InlineData("time,lat,lon,height\n55289,2,3,x", 2, "line 2, column height", "'x' is not a height")]
    [InlineData("time,lat,lon,height\n", 4, "no state in it", "header line of its columns")]
    [InlineData("", 4, "no state in it", "MJD rx ry rz")]
    [InlineData("# only this\n", 4, "no state in it", "MJD rx ry rz")]
    public void Run_WrongBatchFile_NamesLineAndColumn(string content, int exitCode, string place, string message)
    {
        CommandLineRun run = CommandLineRun.Of(
            RefusedRun.WithOutputFolder(_folder, ["--batch-file", "-", "--ephemeris", "builtin"]), content);

        Assert.True(exitCode == run.ExitCode, $"exit code {run.ExitCode}: {run.Error}");
        Assert.Contains(place, run.Error, StringComparison.Ordinal);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }
}
