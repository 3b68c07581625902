using System.Xml;
using System.Xml.Linq;

namespace Msisf.Adapters.Interop;

/// <summary>
/// Values that a format keeps for pixels without data, besides the one that GDAL tells: the special pixels of ISIS cubes, and the
/// constants of PDS4 labels. <c>default</c> is none.
/// </summary>
/// <param name="Values">Single values; null for none.</param>
/// <param name="Lowest">All values below are special.</param>
/// <param name="Highest">All values above are special.</param>
internal readonly record struct SpecialValues(float[]? Values, float Lowest, float Highest)
{
    private const string CubeDriver = "ISIS3";

    /// <summary>GDT_Byte, GDT_UInt16, GDT_Int16, GDT_Float32: their valid values in ISIS cubes.</summary>
    /// <remarks>SpecialPixel.h of ISIS: VALID_MIN and VALID_MAX of each type.</remarks>
    private static readonly Dictionary<int, (float Lowest, float Highest)> ValidInCubes = new()
    {
        [1] = (1.0F, 254.0F),
        [2] = (3.0F, 65522.0F),
        [3] = (-32752.0F, 32767.0F),
        [6] = (-3.4028225e38F, float.MaxValue),
    };

    /// <summary>Whether there are any.</summary>
    public bool Any => Values is not null;

    /// <summary>Those of a file.</summary>
    /// <param name="driver">Short name of GDAL's driver.</param>
    /// <param name="type">GDAL's number of the type of its values.</param>
    /// <param name="label">The label, if it is one of PDS4.</param>
    public static SpecialValues Of(string driver, int type, string label)
    {
        if (driver == CubeDriver && ValidInCubes.TryGetValue(type, out (float Lowest, float Highest) valid))
        {
            return new SpecialValues([], valid.Lowest, valid.Highest);
        }

        float[] constants = ConstantsOf(label);
        return constants.Length == 0 ? default : new SpecialValues(constants, float.NegativeInfinity, float.PositiveInfinity);
    }

    /// <summary>Makes special values NaN.</summary>
    public void Remove(Span<float> values)
    {
        foreach (float constant in Values!)
        {
            values.Replace(constant, float.NaN);
        }

        if (Lowest == float.NegativeInfinity)
        {
            return;
        }

        foreach (ref float value in values)
        {
            value = value >= Lowest && value <= Highest ? value : float.NaN;
        }
    }

    /// <summary>The constants of the class Special_Constants, whatever they are called: missing, invalid, unknown, saturated, ...</summary>
    private static float[] ConstantsOf(string label)
    {
        if (label.Length == 0)
        {
            return [];
        }

        try
        {
            return
            [
                .. XDocument.Parse(label).Descendants().Where(element => element.Name.LocalName == "Special_Constants")
                    .Elements().Where(element => element.Name.LocalName.EndsWith("_constant", StringComparison.Ordinal)
                        || element.Name.LocalName.EndsWith("_saturation", StringComparison.Ordinal))
                    .Select(element => NumberOf(element.Value.Trim())).OfType<float>(),
            ];
        }
        catch (XmlException)
        {
            return []; // GDAL has read what it needs of it
        }
    }

    private static float? NumberOf(string text) =>
        float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out float number) ? number : null;
}
