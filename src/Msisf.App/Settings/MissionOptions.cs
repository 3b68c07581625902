using Msisf.Adapters.Ephemeris;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;

namespace Msisf.App.Settings;

/// <summary>The options of a camera that flies as the files of a mission say.</summary>
internal static class MissionOptions
{
    public static PathSpec Spk { get; } = new(
        "--spk", DecidesBytes.ByStatesOfRun, PathKind.File,
        "Trajectory as a SPICE kernel (SPK); may be given several times: the later one wins")
    {
        TakesSeveral = true,
    };

    public static TextSpec Spacecraft { get; } = new(
        "--spacecraft", DecidesBytes.ByStatesOfRun, "NAME|ID",
        "The spacecraft whose trajectory in the kernels the camera follows, e.g. LRO or -85");

    public static PathSpec Ck { get; } = new(
        "--ck", DecidesBytes.ByStatesOfRun, PathKind.File,
        "Attitude as a SPICE kernel (CK), with --instrument; may be given several times: the later one wins")
    {
        TakesSeveral = true,
    };

    public static TextSpec Instrument { get; } = new(
        "--instrument", DecidesBytes.ByStatesOfRun, "NAME|ID",
        "The instrument whose attitude by CK and frame kernel the camera has, e.g. LRO_LROCNACL or -85600; its instrument kernel also "
            + "gives the camera, if neither --camera nor a size or field of view is given");

    public static TextSpec InstrumentAxes { get; } = new(
        "--instrument-axes", DecidesBytes.ByStatesOfRun, "RIGHT,DOWN",
        "How the image lies in the instrument's axes, or with --aem in the spacecraft's, e.g. +x,+y; the camera looks along right x down")
    {
        DefaultNote = "ITRANSS and ITRANSL of the instrument kernel",
    };

    public static PathSpec Oem { get; } = new(
        "--oem", DecidesBytes.ByStatesOfRun, PathKind.File,
        "Trajectory as a CCSDS orbit ephemeris message (OEM 1.0, 2.0 or 3.0; lines or XML), an ephemeris of STK (.e), or a table of "
            + "vectors of JPL Horizons; .gz too");

    public static PathSpec Aem { get; } = new(
        "--aem", DecidesBytes.ByStatesOfRun, PathKind.File,
        "With a mission's trajectory: attitudes as a CCSDS attitude ephemeris message (AEM 1.0 or 2.0; lines or XML; .gz too)");

    public static ChoiceSpec<Aberration> OfGround { get; } = new(
        "--ground-aberration", DecidesBytes.ByStatesOfRun,
        [("none", Aberration.None), ("lt", Aberration.LightTime), ("lt+s", Aberration.LightTimeAndStellar)],
        "With a mission's files: where the ground is seen: where it is, where it was when it sent the light, or turned by stellar "
            + "aberration too, as in a real image")
    {
        Default = Aberration.None,
    };

    public static NumberSpec Every { get; } = new(
        "--every", DecidesBytes.ByStatesOfRun, "SECONDS",
        "With a mission's files, in place of times: an image each so many seconds of their cover")
    {
        Limits = new NumberRange(0.0, 1e9) { ExcludesMin = true },
    };

    /// <summary>Reads which kernels say where the spacecraft is and how it points.</summary>
    public static SpacecraftKernels ReadKernels(OptionValues values) => new([.. Spk.ReadAll(values)], [.. Ck.ReadAll(values)]);

    /// <summary>The ways in which a mission's files say where the camera is.</summary>
    public static OptionSpec[] Ways { get; } = [Spacecraft, Oem];

    /// <summary>The options that have a meaning with a mission's files only.</summary>
    public static OptionSpec[] All { get; } = [Spk, Spacecraft, Oem, Ck, Instrument, InstrumentAxes, Aem, OfGround, Every];
}
