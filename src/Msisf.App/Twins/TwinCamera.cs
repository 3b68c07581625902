using Msisf.Adapters.Camera;
using Msisf.Adapters.RealImages;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;

namespace Msisf.App.Twins;

/// <summary>The camera of a product: a known one, or the user's.</summary>
/// <param name="Known">What is known of such products; null for a camera of the user's.</param>
/// <param name="Word">What <c>--camera</c> is given.</param>
/// <param name="AxesText">How the image lies in the frame of the instrument, as <c>--instrument-axes</c> has it.</param>
internal sealed record TwinCamera(KnownCamera? Known, string Word, CameraFile File, string AxesText)
{
    private static readonly string[] NamesOfCamera = ["SPACECRAFTNAME", "INSTRUMENTHOSTNAME", "INSTRUMENTID", "INSTRUMENTNAME"];

    public string Name => Known is null ? File.Name : $"{Known.Name}, {Word}";

    /// <summary>How the image lies in the frame of the instrument.</summary>
    public InstrumentAxes Axes => InstrumentAxes.Parse(AxesText);

    /// <param name="nanometres">Wavelength of its band; null if the label does not say it.</param>
    /// <param name="values">The options; they name the renderer.</param>
    /// <exception cref="MsisfException">It is not known, and the user gives none; or it can't draw the product.</exception>
    public static TwinCamera Of(ImageLabel label, double? nanometres, OptionValues values)
    {
        KnownCamera? known = KnownCamera.Of(label);
        string? given = ImageOptions.Camera.ReadIfGiven(values);
        if (known is null && given is null)
        {
            string instrument = string.Join(' ', NamesOfCamera.Select(label.Text)
                .Where(text => text.Length > 0).Distinct());
            throw new BadInputException(
                $"{label.Path}: the camera '{instrument}' is not known. Known are "
                    + $"{string.Join("; ", KnownCamera.All.Select(camera => camera.Name))}. Of others give a camera file: --camera.");
        }

        if (known?.Problem(label) is { } problem)
        {
            throw new BadInputException($"{label.Path}: {known.Name}: {problem}.");
        }

        string word = given ?? known!.Preset(label, nanometres);
        OptionValues withCamera = given is null
            ? values.With([KeyValuePair.Create(ImageOptions.Camera.Name, new OptionValue([word]))])
            : values;
        return new TwinCamera(
            known, word, CameraChoice.Read(withCamera)!,
            MissionOptions.InstrumentAxes.ReadIfGiven(values) ?? known?.Axes(label) ?? "+x,+y");
    }

    /// <summary>When the product was taken.</summary>
    /// <param name="clock">Turns its times into TDB.</param>
    /// <param name="givenPeriod">s: what the user says to be from one exposure to the next; null for what label or camera say.</param>
    /// <exception cref="MsisfException">The label does not say it.</exception>
    public TwinTimes Times(ImageLabel label, TwinClock clock, double? givenPeriod)
    {
        if (Known is not null && givenPeriod is null)
        {
            return Known.Times(label, clock);
        }

        double exposure = label.Seconds("EXPOSUREDURATION") ?? 0.0;
        if (File.Scan is null)
        {
            return new TwinTimes(clock.OfUtc("STARTTIME") + (0.5 * exposure), 0.0);
        }

        double period = givenPeriod ?? label.Seconds("LINEEXPOSUREDURATION") ?? File.Scan.Period ?? throw new UsageException(
            $"neither {label.Path} nor --camera {Word} says how long it is from one line or framelet to the next. Give "
                + $"{ScanOptions.Period.Name}.").About(ScanOptions.Period);
        return new TwinTimes(
            clock.OfUtc("STARTTIME") + (0.5 * (File.Scan.Kind == ScanKind.LineScan ? period : exposure)), period);
    }

    /// <summary>A warning if a cube's own focal length is another one than the camera's; null if it is not, or not known.</summary>
    public string? FocalLengthWarning(ImageLabel label)
    {
        const double same = 1e-5;
        if (Known is null || File.FocalLength is not { } focalLength
            || label.NaifNumbers($"INS{Known.Instrument(label).ToString(CultureInfo.InvariantCulture)}_FOCAL_LENGTH") is not [double cube]
            || label.Text("INSTRUMENTID") == "WAC-VIS" // each of its bands has one of its own
            || Math.Abs((cube / (1000.0 * focalLength)) - 1.0) < same)
        {
            return null;
        }

        return Invariant(
            $"{label.Path}: its SPICE has a focal length of {cube:R} mm, --camera {Word} one of {1000.0 * focalLength:R} mm. For another "
                + $"filter give a camera file: --camera.");
    }
}
