using System.Runtime.Intrinsics;
using Msisf.Adapters.Interop;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>How the stored values of a raster become heights in m: height = offset + factor value.</summary>
/// <param name="Factor">m a step.</param>
/// <param name="Offset">m.</param>
internal readonly record struct HeightRule(double Factor, double Offset)
{
    /// <summary>Whether a stored value is a height: finite, and no farther from the sphere than the Moon's ground is.</summary>
    public bool IsHeight(float value) => Math.Abs(HeightOf(value)) <= MoonConstants.MaxRelief;

    /// <summary>Whether all stored values are heights.</summary>
    public bool AreHeights(ReadOnlySpan<float> values)
    {
        // Float arithmetic may be off by some ulps: what is near the limit is looked at one by one.
        Vector256<float> limit = Vector256.Create((float)(0.999 * MoonConstants.MaxRelief));
        (Vector256<float> offset, Vector256<float> factor) = (Vector256.Create((float)Offset), Vector256.Create((float)Factor));
        int i = 0;
        for (; i <= values.Length - Vector256<float>.Count; i += Vector256<float>.Count)
        {
            if (!Vector256.LessThanOrEqualAll(Vector256.Abs(offset + (factor * Vector256.Create(values[i..]))), limit))
            {
                break;
            }
        }

        while (i < values.Length && IsHeight(values[i]))
        {
            i++;
        }

        return i == values.Length;
    }

    /// <summary>Height of a stored value, m.</summary>
    public double HeightOf(float value) => Offset + (Factor * value);

    /// <summary>The rule of a file: what the user says, else the file, else the table of known products.</summary>
    /// <param name="path">The file, for messages.</param>
    /// <param name="pixel">m: width of a pixel.</param>
    /// <exception cref="BadInputException">The values can't be heights, or their unit is none that is known.</exception>
    public static HeightRule Of(string path, GdalImage image, HeightOptions given, double pixel)
    {
        if (image.IsComplex)
        {
            throw new BadInputException(
                $"{path}: its values are complex numbers, e.g. of radar, not heights. Take the elevation model that was made of them.");
        }

        if (given.Scale is double scale)
        {
            return new HeightRule(scale, given.Offset ?? 0.0);
        }

        (double factor, double offset) = image.Scale;
        double metres = MetresOf(path, image.Unit);
        bool isSilent = (factor, offset) == (1.0, 0.0) && image.Unit.Length == 0;
        metres = isSilent && RasterProducts.Find(path) is { } product ? product.MetresPerStep : metres;
        HeightRule rule = new(metres * factor, (metres * offset) + (given.Offset ?? 0.0));
        bool isUnitKnown = image.Unit.Length > 0 || RasterProducts.Find(path) is not null;
        HeightGuess.Check(path, image, rule, given.Offset ?? 0.0, pixel, isUnitKnown);
        return rule;
    }

    private static double MetresOf(string path, string unit) => unit.ToUpperInvariant() switch
    {
        "" or "M" or "METRE" or "METER" or "METRES" or "METERS" => 1.0,
        "KM" or "KILOMETRE" or "KILOMETER" or "KILOMETRES" or "KILOMETERS" => 1000.0,
        "FT" or "FOOT" or "FEET" or "INTERNATIONAL FOOT" => throw new BadInputException(
            $"{path}: its heights are in '{unit}'; metres or kilometres are needed. If they are, add ,scale=0.3048 to its name."),
        "US-FT" or "US SURVEY FOOT" or "FTUS" or "FOOT_US" => throw new BadInputException(
            $"{path}: its heights are in '{unit}'; metres or kilometres are needed. If they are, add ,scale=0.3048006096 to its name."),
        _ => throw new BadInputException(
            $"{path}: its heights are in '{unit}'; metres or kilometres are needed. Add ,scale=METRES to its name: "
                + $"metres in one '{unit}'."),
    };
}

/// <summary>Recognises values that are no heights in m over the sphere, so that a wrong picture is not drawn.</summary>
internal static class HeightGuess
{
    /// <summary>Blocks of the file that are looked at, along a side of it.</summary>
    private const int BlocksASide = 4;

    /// <summary>px: side of such a block.</summary>
    private const int BlockSide = 64;

    /// <summary>Share of the values that must look like something else.</summary>
    private const double Most = 0.9;

    /// <summary>Tangent of the median slope below which no ground of the Moon is: 0.03 degrees.</summary>
    private const double Flattest = 5e-4;

    /// <summary>Looks at values spread over a file.</summary>
    /// <exception cref="BadInputException">They look like something else than heights, or the user's offset is too large.</exception>
    public static void Check(string path, GdalImage image, HeightRule rule, double given, double pixel, bool isUnitKnown)
    {
        if (image.IsBytes && rule == new HeightRule(1.0, 0.0) && !isUnitKnown)
        {
            throw new BadInputException(
                $"{path}: its values look like a picture or a hillshade: 8-bit numbers from 0 to 255 and no unit. If they are heights all "
                    + "the same, add ,scale=1 to its name: metres a step.");
        }

        (double[] heights, double[] steps) = Sample(image, rule);
        if (heights.Length == 0)
        {
            return; // nothing but no data, which is told elsewhere
        }

        if (IsMost(heights, height => Math.Abs(height) > MoonConstants.MaxRelief)
            && IsMost(heights, height => Math.Abs(height - given) <= MoonConstants.MaxRelief))
        {
            throw new BadInputException(
                $"{path}: offset={Text(given)} makes heights of it such as {Text(heights[0])} m; the Moon's ground is at most "
                    + $"{Text(MoonConstants.MaxRelief)} m off its sphere. Correct the offset.");
        }

        double radius = MoonConstants.ReferenceRadius;
        if (IsMost(heights, height => Math.Abs(height - radius) <= 2.0 * MoonConstants.MaxRelief))
        {
            throw Looks(
                path, $"like radii from the Moon's centre in m (the first is {Text(heights[0])})",
                $"scale={Text(rule.Factor)},offset=-{Text(radius)}");
        }

        if (IsMost(heights, height => Math.Abs((1000.0 * height) - radius) <= 2.0 * MoonConstants.MaxRelief))
        {
            throw Looks(
                path, $"like radii from the Moon's centre in km (the first is {Text(heights[0])})",
                $"scale={Text(1000.0 * rule.Factor)},offset=-{Text(radius)}");
        }

        if (!isUnitKnown && IsMost(heights, height => Math.Abs(height) is > MoonConstants.MaxRelief and < 40_000.0))
        {
            throw Looks(path, $"like feet (the first is {Text(heights[0])})", $"scale={Text(0.3048 * rule.Factor)}");
        }

        double slope = steps.Length == 0 ? 0.0 : steps.Order().ElementAt(steps.Length / 2) / pixel;
        if (!isUnitKnown && slope is > 0.0 and < Flattest && IsMost(heights, height => Math.Abs(height) <= 0.001 * MoonConstants.MaxRelief))
        {
            throw Looks(
                path, $"like kilometres (from {Text(heights.Min())} to {Text(heights.Max())})", $"scale={Text(1000.0 * rule.Factor)}");
        }
    }

    private static bool IsMost(double[] heights, Func<double, bool> test) => heights.Count(test) >= Most * heights.Length;

    private static (double[] Heights, double[] Steps) Sample(GdalImage image, HeightRule rule)
    {
        List<double> heights = [];
        List<double> steps = [];
        (int lines, int samples) = (Math.Min(BlockSide, image.Height), Math.Min(BlockSide, image.Width));
        float[] values = new float[lines * samples];
        for (int block = 0; block < BlocksASide * BlocksASide; block++)
        {
            int line = (image.Height - lines) * (block / BlocksASide) / (BlocksASide - 1);
            int sample = (image.Width - samples) * (block % BlocksASide) / (BlocksASide - 1);
            image.Read(line, lines, sample, samples, values);
            for (int i = 0; i < values.Length; i++)
            {
                double height = rule.Offset + (rule.Factor * values[i]);
                if (!double.IsFinite(height) || Math.Abs(height) > 1e9)
                {
                    continue;
                }

                heights.Add(height);
                if (i >= samples && float.IsFinite(values[i - samples]))
                {
                    steps.Add(Math.Abs(rule.Factor * (values[i] - values[i - samples])));
                }
            }
        }

        return ([.. heights], [.. steps]);
    }

    private static string Text(double number) => number.ToString("G9", CultureInfo.InvariantCulture);

    private static BadInputException Looks(string path, string guess, string option) => new(
        $"{path}: its values look {guess}; heights in m over a sphere are needed. If the guess is right, add ,{option} to its name; if "
            + "they are such heights, ,scale=1.");
}

/// <summary>What the user says of the values of an elevation model; <c>default</c> is nothing.</summary>
/// <param name="Scale">m a step of the stored values; null for what the file, or the table of known products, says.</param>
/// <param name="Offset">m that are added to all heights.</param>
/// <param name="HoldsMeans">Whether samples are means of cells (<see cref="ITerrainGrid.HoldsMeans"/>).</param>
public readonly record struct HeightOptions(double? Scale, double? Offset, bool? HoldsMeans = null)
{
    /// <summary>Whether nothing is said.</summary>
    public bool IsEmpty => this == default;
}
