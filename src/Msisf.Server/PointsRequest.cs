using System.Text.Json;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>A request with a frame and a list of points.</summary>
/// <param name="Points">The points, each with so many numbers as were asked for.</param>
internal sealed record PointsRequest(RequestedFrame Frame, IReadOnlyList<double[]> Points)
{
    /// <summary>Reads a request.</summary>
    /// <param name="json">Its body.</param>
    /// <param name="name">Name of the list.</param>
    /// <param name="fields">Names of the numbers of a point, those that may be left out last.</param>
    /// <param name="needed">How many must be there.</param>
    /// <param name="frames">Reads the frame.</param>
    /// <exception cref="MsisfException">A member is missing, unknown or wrong.</exception>
    public static PointsRequest Read(JsonElement json, string name, string[] fields, int needed, FrameService frames)
    {
        IReadOnlyDictionary<string, JsonElement> members = JsonText.Members(json);
        if (members.Keys.FirstOrDefault(key => key != "frame" && key != name) is { } unknown)
        {
            throw new UsageException($"'{unknown}' is not known here; the request has 'frame' and '{name}'.");
        }

        if (!members.TryGetValue("frame", out JsonElement frame) || !members.TryGetValue(name, out JsonElement list)
            || list.ValueKind != JsonValueKind.Array)
        {
            throw new UsageException(
                $"the request needs 'frame', the options of a frame, and '{name}', a list of [{string.Join(", ", fields)}].");
        }

        return new PointsRequest(
            frames.Read(frame, isOfSeveral: true),
            [.. list.EnumerateArray().Select((point, index) => PointOf(point, name, index, fields, needed))]);
    }

    private static double[] PointOf(JsonElement point, string name, int index, string[] fields, int needed)
    {
        double[]? numbers = point.ValueKind == JsonValueKind.Array && point.EnumerateArray().All(IsNumber)
            ? [.. point.EnumerateArray().Select(number => number.GetDouble())]
            : null;
        return numbers is not null && numbers.Length >= needed && numbers.Length <= fields.Length
            ? numbers
            : throw new UsageException(Invariant($"'{name}', entry {index + 1}: the numbers [{string.Join(", ", fields)}] are needed."));
    }

    private static bool IsNumber(JsonElement value) =>
        value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) && double.IsFinite(number);
}
