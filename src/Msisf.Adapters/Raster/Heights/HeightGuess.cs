using Msisf.Adapters.Interop;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Recognises values that are not heights in m over the sphere, so that a wrong picture is not drawn.</summary>
/// <param name="path">The file, for messages.</param>
/// <param name="image">The file.</param>
/// <param name="rule">What its numbers would mean.</param>
/// <param name="unit">The unit of its values.</param>
/// <param name="given">What the user says of them.</param>
/// <param name="sphere">m: radius of the sphere over which the heights are.</param>
internal sealed class HeightGuess(
    string path, GdalImage image, HeightRule rule, HeightUnit unit, HeightOptions given, double sphere)
{
    /// <summary>Blocks of the file that are looked at, along a side of it.</summary>
    private const int BlocksASide = 8;

    /// <summary>px: side of such a block.</summary>
    private const int BlockSide = 32;

    /// <summary>Share of the values that must look like something else.</summary>
    private const double Most = 0.9;

    /// <summary>Tangent of the median slope below which no ground of the Moon is: 0.03 degrees.</summary>
    private const double Flattest = 5e-4;

    /// <summary>Tangent of the median slope above which no ground of the Moon is: loose ground slips at 35 degrees.</summary>
    private const double Steepest = 0.7;

    /// <summary>m: kilometres taken for metres are less than so much.</summary>
    private const double Kilometres = 20.0;

    /// <summary>m: feet and half metres taken for metres are less than so much.</summary>
    private const double MostFeet = 40_000.0;

    /// <summary>Different values beyond the Moon's heights: fill values are a few.</summary>
    private const int FewFills = 16;

    /// <summary>m: numbers beyond are marks for no data, in whatever unit.</summary>
    private const double NoNumber = 1e12;

    /// <summary>m in the units in which heights are found.</summary>
    private static readonly double[] Units = [1.0, 1000.0, 0.3048, 0.5];

    /// <summary>Looks at values spread over the file.</summary>
    /// <param name="pixel">m: width of a pixel.</param>
    /// <exception cref="BadInputException">They look like something else than heights, or the user's options make none of them.</exception>
    public void Check(double pixel)
    {
        if (image.IsBytes && image.Scale == (1.0, 0.0) && !unit.IsKnown)
        {
            throw new BadInputException(
                $"{path}: its values look like a picture or a hillshade: 8-bit numbers from 0 to 255 and no unit. If they are heights all "
                    + "the same, add ,scale=1 to its name: metres a step.");
        }

        (double[] heights, double[] steps, (double Height, double Step)[] beyond) = Sample();
        if (heights.Length == 0)
        {
            return; // nothing but no data, which another check reports
        }

        bool areNone = IsMost(heights, height => height < rule.Lowest || height > rule.Highest);
        if (areNone && !given.IsSilent)
        {
            throw OptionsAreWrong(heights);
        }

        double radius = MoonConstants.ReferenceRadius;
        if (IsMost(heights, height => Math.Abs(height - radius) <= MoonConstants.MaxRelief))
        {
            throw Looks($"like radii from the Moon's centre in m (the first is {Text(heights[0])})", unit.Metres, -sphere);
        }

        if (IsMost(heights, height => Math.Abs((1000.0 * height) - radius) <= MoonConstants.MaxRelief))
        {
            throw Looks($"like radii from the Moon's centre in km (the first is {Text(heights[0])})", 1000.0 * unit.Metres, -sphere);
        }

        if (!unit.IsKnown)
        {
            CheckUnit(heights, steps, beyond, pixel);
        }
    }

    /// <summary>Heights without a unit are metres, if they and their slopes can be.</summary>
    /// <param name="beyond">m: heights beyond the Moon's, but not far, whose neighbours are as well, and the steps between them.</param>
    private void CheckUnit(double[] heights, double[] steps, (double Height, double Step)[] beyond, double pixel)
    {
        bool isGroundBeyond = beyond.Select(one => one.Height).Distinct().Take(FewFills + 1).Count() > FewFills
            && Median([.. beyond.Select(one => one.Step)]) < pixel;
        double slope = steps.Length == 0 ? 0.0 : Median(steps) / pixel;
        if (isGroundBeyond || slope > Steepest)
        {
            string what = isGroundBeyond
                ? $"they are from {Text(heights.Where(IsLittle).Min())} to {Text(heights.Where(IsLittle).Max())}"
                : Invariant($"half of their slopes are steeper than {double.RadiansToDegrees(Math.Atan(slope)):F0} degrees");
            throw new BadInputException(
                $"{path}: its values look like feet, or like steps of half a metre ({what}); heights in m over a sphere are needed. "
                    + "If they are feet, add ,scale=0.3048 to its name; if steps of half a metre, ,scale=0.5; if such heights, ,scale=1.");
        }

        if (slope is > 0.0 and < Flattest && IsMost(heights, height => Math.Abs(height) <= Kilometres))
        {
            throw Looks($"like kilometres (from {Text(heights.Min())} to {Text(heights.Max())})", 1000.0, 0.0);
        }

        static bool IsLittle(double height) => Math.Abs(height) < MostFeet;
    }

    /// <summary>The error for options with which nothing is a height; it names those with which most values are.</summary>
    private BadInputException OptionsAreWrong(double[] heights)
    {
        double value = (heights.Order().ElementAt(heights.Length / 2) - (given.Offset ?? 0.0)) / unit.Metres;
        IEnumerable<string> others =
            from offset in (double[])[0.0, -sphere]
            from metres in Units
            where (metres * value) + offset is var height && height >= rule.Lowest && height <= rule.Highest
            select OptionsOf(metres, offset, 1.0);
        string words = string.Join(',', ((string?[])[
            given.Scale is { } scale ? $"scale={Text(scale)}" : null, given.Offset is { } added ? $"offset={Text(added)}" : null])
            .OfType<string>());
        string remedy = others.FirstOrDefault() switch
        {
            null => "Correct it.",
            "" => "Leave it out: the values are heights without it.",
            var options => $"The values would be heights with ,{options} instead.",
        };
        return new BadInputException(
            $"{path}: {words} makes heights of it such as {Text(heights[0])} m; the Moon's ground lies from {Text(rule.Lowest)} to "
                + $"{Text(rule.Highest)} m. The file's own scale and offset count as part of its values. {remedy}");
    }

    private static bool IsMost(double[] heights, Func<double, bool> test) => heights.Count(test) >= Most * heights.Length;

    private static double Median(double[] values) => values.Order().ElementAt(values.Length / 2);

    private (double[] Heights, double[] Steps, (double Height, double Step)[] Beyond) Sample()
    {
        List<double> heights = [];
        List<double> steps = [];
        List<(double Height, double Step)> beyond = [];
        (int lines, int samples) = (Math.Min(BlockSide, image.Height), Math.Min(BlockSide, image.Width));
        float[] values = new float[lines * samples];
        for (int block = 0; block < BlocksASide * BlocksASide; block++)
        {
            int line = (int)((long)(image.Height - lines) * (block / BlocksASide) / (BlocksASide - 1));
            int sample = (int)((long)(image.Width - samples) * (block % BlocksASide) / (BlocksASide - 1));
            image.Read(line, lines, sample, samples, values);
            for (int i = 0; i < values.Length; i++)
            {
                double height = rule.HeightOf(values[i]);
                if (!double.IsFinite(height) || Math.Abs(height) > NoNumber)
                {
                    continue;
                }

                heights.Add(height);
                if (i < samples || rule.IsHeight(values[i]) != rule.IsHeight(values[i - samples]))
                {
                    continue;
                }

                double step = Math.Abs(height - rule.HeightOf(values[i - samples]));
                if (rule.IsHeight(values[i]))
                {
                    steps.Add(step);
                }
                else if (Math.Abs(height) < MostFeet)
                {
                    beyond.Add((height, step));
                }
            }
        }

        return ([.. heights], [.. steps], [.. beyond]);
    }

    private BadInputException Looks(string guess, double metres, double offset) => new(
        $"{path}: its values look {guess}; heights in m over a sphere are needed. If the guess is right, add "
            + $",{OptionsOf(metres, offset, unit.Metres)} to its name; if they are such heights, ,scale={Text(unit.Metres)}.");

    /// <param name="silent">m a unit of the values where scale= is left out.</param>
    private static string OptionsOf(double metres, double offset, double silent) => string.Join(',', ((string?[])[
        metres == silent ? null : $"scale={Text(metres)}", offset == 0.0 ? null : $"offset={Text(offset)}"]).OfType<string>());

    private static string Text(double number) => number.ToString("G9", CultureInfo.InvariantCulture);
}
