using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>Each option of a run, changed: bytes and identity of a frame change together, or neither of them.</summary>
public sealed class FrameIdentityTests(IdentityRuns runs) : IClassFixture<IdentityRuns>
{
    private const string Orbit = "--kepler-set {1.9E6,0.01,0,0,1,0} --epoch 55289 --time 55289.01";
    private const string OrbitOfTimes = "--kepler-set {1.9E6,0.01,0,0,1,0} --epoch 55289";
    private const string Place = "--position 10,20,160000 --time 55289";
    private const string Lines = "--camera FILE:line.yaml --motion {0,9E5,0,0,0,0} --lines 16";
    private const string Samples = "--trajectory FILE:a.path --time 55289.00005";
    private const string Far = "--fixed-state {55289,3E6,0,0,0,0,0,1} --fov 20";

    private const string Message = "--oem FILE:near/states.oem --aem FILE:near/states.aem --time 55289.01";

    private const string Kernels = "--spk FILE:near/states.bsp --spacecraft -999 --time 55289.01";

    private const string Pointed = Kernels + " --ck FILE:near/states.bc --kernels FILE:near/states.tsc --kernels FILE:near/states.tf "
        + "--kernels FILE:other.tf --instrument -999001 --instrument-axes +x,+y";

    private const string Map =
        "--albedo-map FILE:WAC_A.IMG --albedo-map-properties scale=0.001,incidence=60,emission=0,phase=60";

    private const string Maps = "--albedo-map FILE:WAC_B.IMG,factor=2 "
        + "--albedo-map FILE:WAC_A.IMG,scale=0.001,incidence=60,emission=0,phase=60";

    /// <summary>Light from the ground takes long: of few pixels.</summary>
    private const string LitGround = "--width 4 --height 4 --indirect --layers indirect";

    /// <summary>Options that POV-Ray alone has, and the choice of it: it is no part of these tests.</summary>
    private static readonly OptionSpec[] OfPovRay = [RendererOptions.Renderer, .. PovOptions.Group.Options];

    /// <summary>They accept or refuse a file or numbers, and change none that are accepted without them.</summary>
    private static readonly string[] Checks = ["--albedo-map-checksum", "--ignore-columns", "--normalize"];

    /// <summary>
    /// The option, the words of the call, and those that replace or join them; FILE: stands before a file of <see cref="IdentityRuns"/>.
    /// </summary>
    public static TheoryData<string, string, string> Changes => new()
    {
        { "--fixed-state", "", "--fixed-state {55289,1.91E6,0,0,0,0,0,1}" },
        { "--batch-file", "--batch-file FILE:a.tab", "--batch-file FILE:b.tab" },
        { "--batch-frame", "--batch-file FILE:a.tab", "--batch-frame j2000" },
        { "--batch-axes", "--batch-file FILE:a.tab", "--batch-axes opencv" },
        { "--batch-rotation", "--batch-file FILE:a.tab", "--batch-rotation to-camera" },
        { "--batch-euler", "--batch-file FILE:euler.csv --batch-euler ZYX", "--batch-euler XYZ" },
        { "--ignore-columns", "--batch-file FILE:euler.csv --batch-euler ZYX", "--ignore-columns" },
        { "--kepler-set", Orbit, "--kepler-set {1.91E6,0.01,0,0,1,0}" },
        { "--state-vectors", "--state-vectors {1.9E6,0,0,0,1600,0} --epoch 55289 --time 55289", "--state-vectors {1.91E6,0,0,0,1600,0}" },
        { "--position", Place, "--position 11,20,160000" },
        { "--epoch", Orbit, "--epoch 55288.99" },
        { "--time", Orbit, "--time 55289.02" },
        { "--times", $"{OrbitOfTimes} --times {{55289.01}}", "--times {55289.02}" },
        { "--time-interval", $"{OrbitOfTimes} --time-interval [55289:1:55289]", "--time-interval [55289.02:1:55289.02]" },
        { "--attitude", $"{Orbit} --attitude {{0,0,0,1}}", "--attitude {0,0,0.28,0.96}" },
        { "--attitude-transition", $"{Orbit} --attitude {{0,0,0,1}}", "--attitude-transition {0,0,1E-4}" },
        { "--attitude-frame", $"{Orbit} --attitude {{0,0,0,1}}", "--attitude-frame moon-me-epoch" },
        { "--orbit-frame", Orbit, "--orbit-frame j2000" },
        { "--oem", Message, "--oem FILE:far/states.oem" },
        { "--aem", Message, "--aem FILE:far/states.aem" },
        { "--every", "--oem FILE:near/states.oem --every 1000 --frames 2 --output-name {step:00000}", "--every 900" },
        { "--spk", Kernels, "--spk FILE:far/states.bsp" },
        { "--spacecraft", Kernels, "--spacecraft 399" },
        { "--ck", Pointed, "--ck FILE:far/states.bc" },
        { "--instrument", Pointed, "--instrument MSISF_OTHER" },
        { "--ground-aberration", Message, "--ground-aberration lt+s" },
        { "--instrument-axes", Pointed, "--instrument-axes -x,-y" },
        { "--ground-aberration", Kernels, "--ground-aberration lt+s" },
        { "--look-at", Place, "--look-at 11,21" },
        { "--off-nadir", Place, "--off-nadir 10" },
        { "--up", Place, "--up sun" },
        { "--roll", Place, "--roll 10" },
        { "--normalize", "", "--normalize" },
        { "--motion", "--camera FILE:shutter.yaml --motion {0,0,0,0,0,0}", "--motion {0,9000,0,0,0,0}" },
        { "--fov", "", "--fov 31" },
        { "--width", "", "--width 33" },
        { "--height", "", "--height 33" },
        { "--camera", "--camera FILE:a.yaml", "--camera FILE:b.yaml" },
        { "--rig", "--rig FILE:a.rig", "--rig FILE:b.rig" },
        { "--lines", Lines, "--lines 17" },
        { "--framelets", "--camera FILE:strip.yaml --motion {0,9E5,0,0,0,0} --framelets 2", "--framelets 3" },
        { "--scan-period", Lines, "--scan-period 0.2" },
        { "--jitter", "--jitter FILE:a.jitter", "--jitter FILE:b.jitter" },
        { "--jitter", $"{Lines} --jitter FILE:a.jitter", "--jitter FILE:b.jitter" },
        { "--trajectory", Samples, "--trajectory FILE:b.path" },
        { "--trajectory-positions", Samples, "--trajectory-positions linear" },
        { "--trajectory-attitudes", Samples, "--trajectory-attitudes squad" },
        { "--ignore-sun", "", "--ignore-sun" },
        { "--sun-position", "", "--sun-position {1.4E11,3E10,0}" },
        { "--aberration", "", "--aberration lt" },
        { "--ephemeris", "", "--ephemeris cspice" },
        { "--kernels", "", "--kernels FILE:other.tm" },
        { "--res", "--ldem FILE:models --res 1", "--res 2" },
        { "--ldem", "--ldem FILE:models/LDEM_2_SYNTHETIC.LBL", "--ldem FILE:others/LDEM_2_SYNTHETIC.LBL" },
        {
            "--ldem", "--ldem FILE:models/LDEM_2_SYNTHETIC.LBL",
            "--ldem FILE:models/LDEM_2_SYNTHETIC.LBL --ldem FILE:models/LDEM_80S_10000M_SYNTHETIC.LBL"
        },
        { "--body", $"{Far} --ldem FILE:models/LDEM_1_SYNTHETIC.LBL", "--body mercury --ldem FILE:mercury/MERCURY_DEM_1_SYNTHETIC.LBL" },
        { "--look", "", "--look photo" },
        { "--lod", "--fixed-state {55289,3E7,0,0,0,0,0,1} --fov 4", "--lod off" },
        { "--lod-error", Far, "--lod-error 5" },
        { "--albedo-map", "--reflectance moon", Map },
        { "--albedo-map", "--reflectance moon", Maps },
        { "--albedo-map", $"--reflectance moon {Maps}", Maps.Replace("factor=2", "factor=3", StringComparison.Ordinal) },
        { "--albedo-map-properties", Map, "--albedo-map-properties scale=0.002,incidence=60,emission=0,phase=60" },
        { "--albedo-map-checksum", Map, "--albedo-map-checksum SHA" },
        { "--band", "--reflectance moon", "--band 415" },
        { "--output-dir", "", "--output-dir FILE:elsewhere" },
        { "--output-name", "", "--output-name other" },
        { "--rendering-annotation", "", "--rendering-annotation" },
        { "--camera-model", "", "--camera-model csm" },
        { "--camera-model", "--camera-model csm", "--camera-model csm,tsai" },
        { "--map", "", "--map orthographic,1000" },
        { "--map", "--map orthographic,1000", "--map orthographic,2000" },
        { "--surface", "", "--surface terrain" },
        { "--grid", "", "--grid 16" },
        { "--gridH", "", "--gridH 16" },
        { "--gridV", "", "--gridV 16" },
        { "--samples", "", "--samples 4" },
        { "--samples", "--samples auto:0.5", "--samples auto:20" },
        { "--shading", "", "--shading smooth" },
        { "--sun", "--position 0,45,160000 --time 55289", "--sun disc" },
        { "--indirect", $"{LitGround} --indirect-error 0.2", "--indirect 2" },
        { "--indirect-error", LitGround, "--indirect-error 0.2" },
        { "--reflectance", "", "--reflectance lommel-seeliger" },
        { "--reflectance", "--reflectance hapke:w=0.3", "--reflectance hapke:w=0.4" },
        { "--hapke-map", "--reflectance moon", "--hapke-map FILE:hapke.img" },
        { "--albedo", "", "--albedo 0.3" },
        { "--exposure", "", "--exposure 2" },
        { "--transfer", "", "--transfer linear" },
        { "--bit-depth", "", "--bit-depth 16" },
        { "--exposure-time", "--camera FILE:detector.yaml", "--exposure-time 0.3" },
        { "--noise-seed", "--camera FILE:detector.yaml", "--noise-seed 5" },
        { "--exposure-factor", "", "--exposure-factor 2" },
        { "--refine", "--refine 7 --refine-cell 512", "--refine 8" },
        { "--refine-cell", "--refine 7 --refine-cell 512", "--refine-cell 1024" },
        { "--layers", "--layers mask", "--layers mask,depth" },
        { "--layers-format", "--layers mask", "--layers-format npy" },
        { "--layers-precision", "--layers depth", "--layers-precision single" },
        { "--layers-compression", "--layers depth", "--layers-compression gzip" },
        { "--craters", "", "--craters FILE:craters.csv" },
        { "--craters", "--craters FILE:craters.csv", "--craters FILE:more.csv" },
        { "--sensitivity", "", "--sensitivity albedo" },
        { "--certify", "", "--certify height=1" },
        { "--certify-sigmas", "--certify height=1", "--certify height=1 --certify-sigmas 2" },
        { "--information", "--camera FILE:detector.yaml", "--information pose" },
        { "--crater-rim", "--craters FILE:craters.csv", "--crater-rim terrain" },
        { "--crater-size", "--craters FILE:craters.csv", "--crater-size 1" },
        { "--landmarks", "", "--landmarks FILE:landmarks.csv" },
        { "--columns", "--landmarks FILE:landmarks.csv", "--columns id=lat" },
        { "--flow", "", "--flow {55289,1.9E6,9E3,0,0,0,0.28,0.96}" },
        { "--stereo", "", "--stereo 100" },
        { "--sky", $"{Place} --look-at horizon:0", "--sky" },
        { "--planets", $"{Place} --look-at horizon:0", "--planets" },
        { "--earth", $"{Place} --look-at horizon:0", "--earth" },
        { "--sun-in-view", $"{Place} --look-at horizon:0", "--sun-in-view" },
        { "--earthshine", "--position 10,20,160000 --time 55303 --exposure 100000", "--earthshine" }, // at night
        { "--stars", $"{Place} --look-at horizon:0", "--stars" },
        { "--star-limit", $"{Place} --look-at horizon:0 --stars", "--star-limit 3" },
        { "--flow-format", "--stereo 100", "--flow-format npy" },
        { "--jobs", "", "--jobs 2" },
        { "--frames", "", "--frames 1" },
        { "--overwrite", "", "--overwrite" },
        { "--fail-fast", "", "--fail-fast" },
        { "--batch", "", "--batch" },
        { "--frame-times", "", "--frame-times FILE:times.tsv" },
        { "--timing", "", "--timing" },
        { "--config", "", "--config FILE:config.yaml" },
    };

    [Fact]
    public void Changes_AreOfAllOptionsOfARun() => Assert.Equal(
        CommandTable.OptionsOfRun.Except(OfPovRay).Select(option => option.Name).Order(StringComparer.Ordinal),
        Changes.Select(change => (string)change[0]).Distinct().Order(StringComparer.Ordinal));

    [RequiresTheory(Part.Ldem4, Part.CSpice, Part.CFitsio)]
    [MemberData(nameof(Changes))]
    public void Change_OfAnOption_ChangesBytesAndIdentityTogether(string name, string words, string change)
    {
        DrawnFrame before = runs.Of(words);
        DrawnFrame after = runs.Of(words, change);
        bool hasOtherBytes = !before.Files.SequenceEqual(after.Files);
        bool hasOtherIdentity = before.Identity != after.Identity;

        Assert.Equal(hasOtherIdentity, hasOtherBytes);
        OptionSpec option = CommandTable.OptionsOfRun.First(option => option.Name == name);
        Assert.Equal(option.Role is DecidesBytes && !Checks.Contains(name), hasOtherIdentity);
        Assert.Equal(hasOtherIdentity, !before.FilesWithoutArguments.SequenceEqual(after.FilesWithoutArguments));
    }
}
