using System.Text.Json;

namespace Msisf.Adapters.IO;

/// <summary>Writes arrays of numbers that read back to the bit.</summary>
internal static class JsonNumbers
{
    /// <summary>A property that is an array.</summary>
    public static void WriteNumbers(this Utf8JsonWriter json, string name, params IEnumerable<double> numbers)
    {
        json.WritePropertyName(name);
        json.WriteNumbers(numbers);
    }

    /// <summary>A property that is the three numbers of a vector.</summary>
    public static void WriteNumbers(this Utf8JsonWriter json, string name, Vector3D vector) =>
        json.WriteNumbers(name, vector.X, vector.Y, vector.Z);

    /// <summary>An array in another one.</summary>
    public static void WriteNumbers(this Utf8JsonWriter json, params IEnumerable<double> numbers)
    {
        json.WriteStartArray();
        foreach (double number in numbers)
        {
            json.WriteNumberValue(number);
        }

        json.WriteEndArray();
    }
}
