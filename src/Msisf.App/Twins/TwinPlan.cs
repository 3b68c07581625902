using System.Buffers.Binary;
using Msisf.Adapters.Camera;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Input;
using Msisf.Adapters.RealImages;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Comparison;
using Msisf.Core.Time;

namespace Msisf.App.Twins;

/// <summary>How the twin of a product is drawn: exposures, and which of their pixels make those of the product.</summary>
/// <param name="Start">TDB seconds past J2000: middle of the first exposure.</param>
/// <param name="Period">s from one exposure to the next.</param>
internal sealed record TwinPlan(double Start, double Period, int Exposures, ProductPixels Pixels)
{
    private const int MostReduced = 10_000;

    /// <param name="times">When it was taken.</param>
    /// <param name="known">What is known of such products; null for a camera of the user's.</param>
    /// <param name="window">Lines of the product to draw, from 1; null for all.</param>
    /// <exception cref="BadInputException">The product's size does not go with its camera.</exception>
    public static TwinPlan Of(ImageLabel label, CameraFile camera, TwinTimes times, KnownCamera? known, (int First, int Last)? window)
    {
        int summing = known?.Summing(label) ?? 1;
        int first = known?.FirstSample(label) ?? 0;
        (_, int lines, int samples) = label.Pixels.Size;
        int whole = (camera.Model.Width - first) / Math.Max(1, summing);
        (int reduced, int sampleOffset, int lineOffset) = PartOf(label, whole, samples, lines);
        if (summing < 1 || first < 0 || reduced < 1 || sampleOffset < 0 || lineOffset < 0
            || sampleOffset + ((long)samples * reduced) > whole)
        {
            throw Unfit(label, camera, samples, "samples");
        }

        if (window is { } part)
        {
            RequireLines(label, camera, part, lines);
            (lineOffset, lines) = (lineOffset + ((part.First - 1) * reduced), part.Last - part.First + 1);
        }

        int ofCamera = checked(lines * reduced);
        (int skipped, int step, int exposures, Func<int, int> rowOf) = camera.Scan?.Kind switch
        {
            ScanKind.LineScan => (lineOffset, 1, ofCamera, line => line - lineOffset),
            ScanKind.PushFrame => Framelets(label, camera, lineOffset + ofCamera, reduced),
            _ when lineOffset + ofCamera > camera.Model.Height => throw Unfit(label, camera, lines, "lines"),
            _ => (0, 1, 1, (Func<int, int>)(line => line)),
        };
        return new TwinPlan(
            times.Start + (skipped * times.Period), step * times.Period, exposures,
            new ProductPixels(
                samples, lines, first + (sampleOffset * summing), summing * reduced, reduced,
                [.. Enumerable.Range(lineOffset, ofCamera).Select(rowOf)]));
    }

    /// <summary>How many pixels of the camera make one of the product on each side, and how many are before the first one.</summary>
    private static (int Reduced, int Sample, int Line) PartOf(ImageLabel label, int whole, int samples, int lines)
    {
        if (label.Number("ALPHASTARTINGSAMPLE") is not { } startSample)
        {
            return (whole % samples == 0 ? whole / samples : 1, 0, 0);
        }

        double startLine = Alpha("ALPHASTARTINGLINE");
        double across = (Alpha("ALPHAENDINGSAMPLE") - startSample) / samples;
        double down = (Alpha("ALPHAENDINGLINE") - startLine) / lines;
        int[] numbers = [Whole(across), Whole(startSample - 0.5), Whole(startLine - 0.5)];
        return Whole(down) == numbers[0] && numbers.All(number => number >= 0)
            ? (numbers[0], numbers[1], numbers[2])
            : throw new BadInputException(
                $"{label.Path}: by its group AlphaCube its pixels are not whole ones of the camera, nor squares of them. Take a cube "
                    + "that is cropped or reduced by whole numbers.");

        double Alpha(string name) => label.Number(name)
            ?? throw new BadInputException($"{label.Path}: the group AlphaCube has no {name}. Get the cube again.");

        static int Whole(double number) =>
            number is >= 0.0 and < MostReduced * 10_000.0 && Math.Abs(number - Math.Round(number)) < 1e-6 ? (int)Math.Round(number) : -1;
    }

    private static (int Skipped, int Step, int Exposures, Func<int, int> RowOf) Framelets(
        ImageLabel label, CameraFile camera, int lines, int reduced)
    {
        int height = camera.Scan!.Framelet is { } rows ? rows.End - rows.First : camera.Model.Height;
        int count = (int)(label.Number("NUMFRAMELETS") ?? (lines / height));
        if (count < 1 || lines > (long)count * height)
        {
            throw new BadInputException(Invariant(
                $"{label.Path}: {count} framelets of {height} lines are fewer than the {lines} lines of the camera that the cube shows. Is "
                    + $"it cropped without ISIS's crop?"));
        }

        bool isFlipped = label.Text("DATAFLIPPED").Equals("Yes", StringComparison.OrdinalIgnoreCase);
        string kept = label.Text("FRAMELETS").ToUpperInvariant();
        if (isFlipped && reduced > 1)
        {
            throw new BadInputException(
                $"{label.Path}: a cube whose framelets are in reverse order (DataFlipped) can be compared as lrowac2isis wrote it only, "
                    + "not reduced.");
        }

        // Reversed, the first of odd framelets may be any: all are drawn, and those without pixels do not count.
        return (isFlipped, kept) switch
        {
            (true, _) => (0, 1, count, line => Row(count - 1 - (line / height), line)),
            (_, "ODD") => (0, 2, (count + 1) / 2, line => line / height % 2 == 0 ? Row(line / height / 2, line) : -1),
            (_, "EVEN") => (1, 2, count / 2, line => line / height % 2 == 1 ? Row(line / height / 2, line) : -1),
            _ => (0, 1, count, line => line),
        };

        int Row(int exposure, int line) => (exposure * height) + (line % height);
    }

    private static void RequireLines(ImageLabel label, CameraFile camera, (int First, int Last) part, int lines)
    {
        if (camera.Scan?.Kind != ScanKind.LineScan)
        {
            throw new UsageException("--image-lines is for line-scan cameras: others are drawn as a whole. Leave it out.");
        }

        if (part.Last > lines)
        {
            throw new UsageException(Invariant($"--image-lines {part.First}-{part.Last}: {label.Path} has {lines} lines."));
        }
    }

    private static BadInputException Unfit(ImageLabel label, CameraFile camera, int size, string what) => new(Invariant(
        $"{label.Path}: {size} {what} are not of camera {camera.Name}, which has {camera.Model.Width} x {camera.Model.Height} px. Was it "
            + $"cropped or scaled by a program that does not say so (AlphaCube)?"));
}

/// <summary>The band of a product that is compared.</summary>
/// <param name="Index">From 0.</param>
/// <param name="Nanometres">Its middle; null if the label does not say it.</param>
internal sealed record TwinBand(int Index, double? Nanometres)
{
    /// <exception cref="MsisfException">The product does not have the band.</exception>
    public static TwinBand Of(ImageLabel label, OptionValues values)
    {
        int count = label.Pixels.Size.Bands;
        LabelValue? center = label.Find("CENTER") ?? label.Find("CENTERFILTERWAVELENGTH") ?? label.Find("CENTERWAVELENGTH");
        double?[] wavelengths = [.. (center?.Items ?? []).Select(item => Parse(item, center!.Unit))];
        bool isKnown = wavelengths.Length == count && wavelengths.All(wavelength => wavelength is not null);
        int index = TwinOptions.Band.ReadIfGiven(values) is { } given ? given - 1
            : isKnown ? Array.IndexOf(wavelengths, wavelengths.MinBy(found => Math.Abs(found!.Value - AlbedoOptions.Band.Read(values))))
            : 0;
        return index < count
            ? new TwinBand(index, isKnown ? wavelengths[index] : null)
            : throw TwinOptions.Band.Wrong(Invariant($"{index + 1}: {label.Path} has {count} bands."));
    }

    /// <summary>ISIS's labels have 643, 0.415 in micrometres, and 640nm.</summary>
    private static double? Parse(string text, string? unit)
    {
        string digits = text.EndsWith("nm", StringComparison.OrdinalIgnoreCase) ? text[..^2] : text;
        return !double.TryParse(digits, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || number <= 0.0 ? null
            : unit?.StartsWith("micro", StringComparison.OrdinalIgnoreCase) == true || number < 10.0 ? 1000.0 * number
            : number;
    }
}

/// <summary>Turns the times of a label into TDB seconds past J2000.</summary>
/// <param name="kernels">Has the leap seconds, and perhaps the spacecraft's clock.</param>
/// <param name="spacecraft">NAIF's number.</param>
internal sealed class TwinClock(ImageLabel label, OpenedEphemeris kernels, int spacecraft)
{
    private const string Computed = "_COMPUTED";

    /// <summary>The time of a count of the spacecraft's clock; null without the keyword, or if nothing here knows the clock.</summary>
    /// <exception cref="BadInputException">It is not a count.</exception>
    public double? OfCount(string name) => OfCube(name)
        ?? (label.Find(name) is { } count && SpacecraftClock.IsIn(kernels.Catalogue.Pool, spacecraft)
            ? SpacecraftClock.Read(kernels.Catalogue.Pool, spacecraft, kernels.Engine.TimeScale).TimeOf(count.Text)
            : null);

    /// <summary>The time of a count as a cube has kept it: ISIS stores the clock's answer as the bytes of a double.</summary>
    /// <param name="name">The keyword of the count.</param>
    /// <returns>Null if the cube has none.</returns>
    /// <exception cref="BadInputException">It is not a time.</exception>
    public double? OfCube(string name)
    {
        string? known = label.Find(name) is not { Text: var count } ? null : label.Naif.Keys.FirstOrDefault(
            key => key.StartsWith("CLOCK_ET_", StringComparison.Ordinal) && key.EndsWith($"_{count}{Computed}", StringComparison.Ordinal));
        return known is null ? null
            : label.Naif[known].Text is var hex && hex.Length == 2 * sizeof(double) && hex.All(char.IsAsciiHexDigit)
                ? BinaryPrimitives.ReadDoubleLittleEndian(Convert.FromHexString(hex))
            : throw new BadInputException($"{label.Path}: {known} is '{hex}'; 16 hexadecimal digits are needed.");
    }

    /// <summary>The time of a keyword in UTC.</summary>
    /// <exception cref="BadInputException">It is missing, or no time.</exception>
    public double OfUtc(string name)
    {
        string text = label.Text(name);
        return TimeText.TryParse(text.EndsWith('Z') ? text : text + "Z", out CalendarTime time)
            ? kernels.Engine.TimeScale.InstantOf(time).Tdb.Seconds
            : throw new BadInputException(
                text.Length == 0
                    ? $"{label.Path}: the label has no {name}: when the image was taken is not known."
                    : $"{label.Path}: {name} is '{text}'; a time such as 2009-07-30T12:20:38.185 is needed.");
    }
}
