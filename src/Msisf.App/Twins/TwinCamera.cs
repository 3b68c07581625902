using System.Text.RegularExpressions;
using Msisf.Adapters.Camera;
using Msisf.Adapters.IO;
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

    /// <summary>Whether the user gives the camera.</summary>
    public bool IsGiven { get; init; }

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
            MissionOptions.InstrumentAxes.ReadIfGiven(values) ?? known?.Axes(label) ?? "+x,+y")
        {
            IsGiven = given is not null,
        };
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

    /// <summary>
    /// The same camera with the focal length and the lens that a cube's own keywords state, as a camera file of its own; this one if they
    /// are the same, or the label has none.
    /// </summary>
    /// <param name="makePath">The file that is written; asked only if one is.</param>
    /// <param name="note">Receives a sentence about what is used.</param>
    /// <exception cref="MsisfException">The keywords make no camera, or the file can't be written.</exception>
    public TwinCamera WithKeywords(ImageLabel label, Func<string> makePath, Action<string> note)
    {
        const double same = 1e-9; // relative: keywords are printed with ten digits or more
        if (Known is null || IsGiven)
        {
            return this;
        }

        string code = $"INS{Known.Instrument(label).ToString(CultureInfo.InvariantCulture)}";
        string text = System.IO.File.ReadAllText(File.Path);
        List<string> changed = [];
        foreach ((string keyword, Regex place) in Known.Keywords)
        {
            if (label.NaifNumbers($"{code}_{keyword}") is [double stated] && place.Match(text) is { Success: true } found
                && Math.Abs((double.Parse(found.Value, CultureInfo.InvariantCulture) / stated) - 1.0) > same)
            {
                text = $"{text[..found.Index]}{stated.ToString("R", CultureInfo.InvariantCulture)}{text[(found.Index + found.Length)..]}";
                changed.Add(Invariant($"{keyword} {stated:R}"));
            }
        }

        if (changed.Count == 0)
        {
            return this;
        }

        string path = makePath();
        note($"{label.Path}: its own keywords state {string.Join(" and ", changed)}, which the twin has: {path}.");
        AtomicFile.WriteText(path, writer => writer.Write(text));
        return this with { Word = path, File = CameraFileReader.Read(path) };
    }
}
