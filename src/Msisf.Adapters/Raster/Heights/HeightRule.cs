using System.Runtime.Intrinsics;
using Msisf.Adapters.Interop;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>How the stored numbers of a raster become heights in m: height = offset + factor number.</summary>
/// <param name="Factor">m a step.</param>
/// <param name="Offset">m.</param>
/// <param name="Lowest">m: what is lower is not a height.</param>
/// <param name="Highest">m: what is higher is not a height.</param>
internal readonly record struct HeightRule(double Factor, double Offset, double Lowest, double Highest)
{
    /// <summary>m: by so much and more sums in floats may be off; what is so near to a limit is looked at one by one.</summary>
    private const double FloatMargin = 100.0;

    /// <summary>Whether a stored number is a height: the Moon has ground there.</summary>
    public bool IsHeight(float number) => HeightOf(number) is var height && height >= Lowest && height <= Highest;

    /// <summary>Whether all stored numbers are heights.</summary>
    public bool AreHeights(ReadOnlySpan<float> numbers)
    {
        Vector256<float> least = Vector256.Create((float)(Lowest + FloatMargin));
        Vector256<float> most = Vector256.Create((float)(Highest - FloatMargin));
        (Vector256<float> offset, Vector256<float> factor) = (Vector256.Create((float)Offset), Vector256.Create((float)Factor));
        int i = 0;
        for (; i <= numbers.Length - Vector256<float>.Count; i += Vector256<float>.Count)
        {
            Vector256<float> height = offset + (factor * Vector256.Create(numbers[i..]));
            if (!Vector256.GreaterThanOrEqualAll(height, least) || !Vector256.LessThanOrEqualAll(height, most))
            {
                break;
            }
        }

        while (i < numbers.Length && IsHeight(numbers[i]))
        {
            i++;
        }

        return i == numbers.Length;
    }

    /// <summary>Height of a stored number, m.</summary>
    public double HeightOf(float number) => Offset + (Factor * number);

    /// <summary>The rule of a file: its own factor and offset make values of its numbers, which are heights in a unit.</summary>
    /// <param name="path">The file, for messages.</param>
    /// <param name="pixel">m: width of a pixel.</param>
    /// <param name="sphere">m: radius of the sphere over which the heights are.</param>
    /// <exception cref="BadInputException">The values can't be heights, or their unit is none that is known.</exception>
    public static HeightRule Of(string path, GdalImage image, HeightOptions given, double pixel, double sphere)
    {
        if (image.IsComplex)
        {
            throw new BadInputException(
                $"{path}: its values are complex numbers, e.g. of radar, not heights. Take the elevation model that was made of them.");
        }

        (double factor, double offset) = image.Scale;
        if (factor == 0.0 || !double.IsFinite(factor) || !double.IsFinite(offset))
        {
            throw new BadInputException(Invariant(
                $"{path}: its band has a scale of {factor:R} and an offset of {offset:R}, so that all heights would be the same, or none. ")
                    + "If its numbers are heights in metres, write it anew with gdal_translate -a_scale 1 -a_offset 0.");
        }

        HeightUnit unit = HeightUnit.Of(path, image, given);
        double below = MoonConstants.ReferenceRadius - sphere;
        HeightRule rule = new(
            unit.Metres * factor, (unit.Metres * offset) + (given.Offset ?? 0.0), below + MoonConstants.PlausibleHeights.Min,
            below + MoonConstants.PlausibleHeights.Max);
        new HeightGuess(path, image, rule, unit, given, sphere).Check(pixel);
        return rule;
    }
}

/// <summary>The unit of a raster's values.</summary>
/// <param name="Metres">m.</param>
/// <param name="IsKnown">Whether somebody says it: the user, the file, or the table of known products.</param>
internal readonly record struct HeightUnit(double Metres, bool IsKnown)
{
    /// <summary>The unit that the user says, otherwise the file, otherwise the table of known products; otherwise metres.</summary>
    /// <exception cref="BadInputException">The file's is none that is known.</exception>
    public static HeightUnit Of(string path, GdalImage image, HeightOptions given)
    {
        if (given.Scale is double scale)
        {
            return new HeightUnit(scale, IsKnown: true);
        }

        RasterProduct? product = RasterProducts.Find(path);
        return image.Unit.Length > 0 ? new HeightUnit(MetresOf(path, image.Unit), IsKnown: true)
            : product is null ? new HeightUnit(1.0, IsKnown: false)
            : new HeightUnit(image.Scale == (1.0, 0.0) ? product.MetresPerStep : 1.0, IsKnown: true);
    }

    private static double MetresOf(string path, string unit) => unit.ToUpperInvariant() switch
    {
        "M" or "METRE" or "METER" or "METRES" or "METERS" => 1.0,
        "KM" or "KILOMETRE" or "KILOMETER" or "KILOMETRES" or "KILOMETERS" => 1000.0,
        "FT" or "FOOT" or "FEET" or "INTERNATIONAL FOOT" => throw new BadInputException(
            $"{path}: its heights are in '{unit}'; m or km are needed. If they are feet, add ,scale=0.3048 to its name."),
        "US-FT" or "US SURVEY FOOT" or "FTUS" or "FOOT_US" => throw new BadInputException(
            $"{path}: its heights are in '{unit}'; m or km are needed. If they are feet, add ,scale=0.3048006096 to its name."),
        _ => throw new BadInputException(
            $"{path}: its heights are in '{unit}'; metres or kilometres are needed. Add ,scale=METRES to its name: "
                + $"metres in one '{unit}'."),
    };
}

/// <summary>What the user says of the values of an elevation model; <c>default</c> is nothing.</summary>
/// <param name="Scale">
/// m a unit of the values, of which the file's own factor and offset are a part; null for what the file, or the table of known products,
/// says.
/// </param>
/// <param name="Offset">m that are added to all heights.</param>
/// <param name="HoldsMeans">Whether samples are means of cells (<see cref="ITerrainGrid.HoldsMeans"/>).</param>
public readonly record struct HeightOptions(double? Scale, double? Offset, bool? HoldsMeans = null)
{
    /// <summary>Whether nothing is said.</summary>
    public bool IsEmpty => this == default;

    /// <summary>Whether nothing is said of what the numbers mean in m.</summary>
    public bool IsSilent => (Scale, Offset) == (null, null);
}
