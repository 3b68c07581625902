using System.Text;
using System.Text.Json;

namespace Msisf.Adapters.CameraExport;

/// <summary>
/// Numbers that read back to the bit and have a point: USGSCSM takes an array for one of whole numbers if its first element has none.
/// </summary>
internal static class ExportedNumber
{
    public static string Real(double value)
    {
        string text = value.ToString("R", CultureInfo.InvariantCulture);
        int exponent = text.IndexOf('E', StringComparison.Ordinal);
        return text.Contains('.', StringComparison.Ordinal) ? text
            : exponent < 0 ? text + ".0"
            : text.Insert(exponent, ".0");
    }

    public static string Reals(string separator, params IEnumerable<double> values) => string.Join(separator, values.Select(Real));

    /// <summary>A JSON object.</summary>
    public static string Json(Action<Utf8JsonWriter> write)
    {
        using MemoryStream stream = new();
        using (Utf8JsonWriter json = new(stream))
        {
            json.WriteStartObject();
            write(json);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    /// <summary>A property that is an object.</summary>
    public static void Object(this Utf8JsonWriter json, string name, Action write)
    {
        json.WriteStartObject(name);
        write();
        json.WriteEndObject();
    }

    /// <summary>A property that is a number.</summary>
    public static void Real(this Utf8JsonWriter json, string name, double value)
    {
        json.WritePropertyName(name);
        json.WriteRawValue(Real(value));
    }

    /// <summary>A property that is an array.</summary>
    public static void Array(this Utf8JsonWriter json, string name, params IEnumerable<double> values)
    {
        json.WritePropertyName(name);
        json.WriteRawValue($"[{Reals(",", values)}]");
    }

    /// <summary>A property that is an array of arrays.</summary>
    public static void Rows(this Utf8JsonWriter json, string name, IEnumerable<double[]> rows)
    {
        json.WritePropertyName(name);
        json.WriteRawValue($"[{string.Join(',', rows.Select(row => $"[{Reals(",", row)}]"))}]");
    }

    /// <summary>The three numbers of a vector.</summary>
    public static double[] Of(Vector3D v) => [v.X, v.Y, v.Z];
}
