using System.Text;
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
internal sealed partial record TwinCamera(KnownCamera? Known, string Word, CameraFile File, string AxesText)
{
    private static readonly string[] NamesOfCamera = ["SPACECRAFTNAME", "INSTRUMENTHOSTNAME", "INSTRUMENTID", "INSTRUMENTNAME"];

    /// <summary>Whether the user gives the camera.</summary>
    public bool IsGiven { get; init; }

    public string Name => Known is null ? File.Name : $"{Known.Name}, {Word}";

    /// <summary>Whether the user says how the image lies in the frame of the instrument.</summary>
    public bool HasGivenAxes { get; init; }

    /// <summary>The camera file by the cube's own keywords; null if there is none.</summary>
    public string? OwnText { get; init; }

    /// <summary>How the image lies there by the cube's own keywords; null for how the preset lies.</summary>
    public InstrumentAxes? OwnAxes { get; init; }

    /// <summary>How the image lies in the frame of the instrument.</summary>
    public InstrumentAxes Axes => OwnAxes ?? InstrumentAxes.Parse(AxesText);

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
                    + $"{string.Join("; ", KnownCamera.All.Select(camera => camera.Name))}. For others give a camera file: --camera.");
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
            HasGivenAxes = MissionOptions.InstrumentAxes.ReadIfGiven(values) is not null,
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

    /// <summary>The same camera with the optics that a cube's own keywords state, as a camera file of its own.</summary>
    /// <param name="path">The file, which <see cref="Save"/> writes.</param>
    /// <param name="hasKernels">Whether the attitude is that of kernels, in whose frame the image lies as the preset does.</param>
    /// <returns>
    /// This one for a camera of the user's, for a label that does not have all of these keywords, and where the image lies otherwise.
    /// </returns>
    /// <exception cref="MsisfException">The keywords make no camera.</exception>
    public TwinCamera WithKeywords(ImageLabel label, string path, bool hasKernels)
    {
        if (Known is not { HasOwnLens: true } || IsGiven || label.Tables is null)
        {
            return this;
        }

        int instrument = Known.Instrument(label);
        string prefix = Invariant($"INS{instrument}_");
        if (InstrumentKernel.OfCube(
            label.Naif.Keys.Where(key => key.StartsWith(prefix, StringComparison.Ordinal))
                .Select(key => KeyValuePair.Create(key, label.NaifNumbers(key)!)),
            instrument, File.Model.Width, File.Model.Height, label.Path) is not { } kernel || (hasKernels && kernel.Axes() != Axes))
        {
            return this;
        }

        string text = WithSections(kernel.CameraText(), System.IO.File.ReadAllText(File.Path));
        return this with
        {
            Word = path,
            File = CameraFileReader.Parse(Encoding.UTF8.GetBytes(text), path, Word),
            OwnText = text,
            OwnAxes = HasGivenAxes ? null : kernel.Axes(),
        };
    }

    /// <summary>Writes the camera file of a cube's own keywords, if there is one.</summary>
    /// <param name="note">Receives a sentence about it.</param>
    /// <exception cref="MsisfException">It can't be written.</exception>
    public void Save(Action<string> note)
    {
        if (OwnText is { } text)
        {
            AtomicFile.WriteText(Word, writer => writer.Write(text));
            note($"The twin has the optics that the cube's own keywords state: {Word}.");
        }
    }

    /// <summary>A camera file with the sections of the preset that it does not have, but for the lens: scan, detector.</summary>
    private static string WithSections(string own, string preset)
    {
        HashSet<string> keys = [.. Section().Split(own).Select(KeyOf), "distortion"];
        return own + string.Concat(Section().Split(preset).Where(section => KeyOf(section).Length > 0 && !keys.Contains(KeyOf(section))));
    }

    /// <summary>The key of a section; empty for comments above the first.</summary>
    private static string KeyOf(string section) =>
        section is ['#', ..] || !section.Contains(':', StringComparison.Ordinal) ? string.Empty : section.Split(':')[0];

    [GeneratedRegex(@"(?m)^(?=[\w-]+:)")]
    private static partial Regex Section();
}
