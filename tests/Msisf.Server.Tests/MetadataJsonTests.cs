using System.Text.Json;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>The meta file as JSON has the members and numbers of the one in XML, of all kinds of pixels.</summary>
public sealed class MetadataJsonTests(ServerOfSeveral server) : IClassFixture<ServerOfSeveral>
{
    private const string Place = "\"position\": [-80.5, 20, 60000], \"time\": 55289.25, \"width\": 60, \"height\": 40, \"grid\": 3, ";

    [RequiresTheory(Part.CSpice)]
    [InlineData("\"look-at\": \"nadir\", \"surface\": \"terrain\", \"fov\": 60, \"sun\": \"disc\"")]
    [InlineData("\"look-at\": \"horizon:30\", \"surface\": \"terrain\", \"fov\": 80")]
    [InlineData("\"look-at\": \"nadir\", \"surface\": \"sphere\", \"fov\": 40")]
    [InlineData("\"look-at\": \"nadir\", \"surface\": \"sphere\", \"fov\": 40, \"ignore-sun\": true")]
    [InlineData("\"look-at\": \"sun\", \"surface\": \"terrain\", \"fov\": 5")]
    [InlineData("\"look-at\": \"nadir\", \"surface\": \"terrain\", \"fov\": 70, "
        + "\"model\": [\"LDEM_2_SYNTHETIC\", \"LDEM_80S_10000M_SYNTHETIC\"]")]
    public async Task Members_AreThoseOf_TheElements(string options)
    {
        using MemoryStream xml = new(await server.Running.RenderAsync(Place + options, "application/xml"));
        using MemoryStream converted = new();
        MetadataJson.Write(converted, xml);

        AssertSame(
            JsonDocument.Parse(converted.ToArray()).RootElement,
            JsonDocument.Parse(await server.Running.RenderAsync(Place + options, "application/json")).RootElement, "meta");
    }

    /// <summary>The XML has 16 digits of each number, which is 1e-15 of it at most.</summary>
    private static void AssertSame(JsonElement expected, JsonElement actual, string path)
    {
        Assert.True(expected.ValueKind == actual.ValueKind, $"{path}: {expected} is {actual}");
        switch (expected.ValueKind)
        {
            case JsonValueKind.Object:
                Assert.Equal(expected.EnumerateObject().Select(one => one.Name), actual.EnumerateObject().Select(one => one.Name));
                foreach (JsonProperty one in expected.EnumerateObject())
                {
                    AssertSame(one.Value, actual.GetProperty(one.Name), $"{path}.{one.Name}");
                }

                break;
            case JsonValueKind.Array:
                Assert.Equal(expected.GetArrayLength(), actual.GetArrayLength());
                foreach ((JsonElement one, JsonElement other) in expected.EnumerateArray().Zip(actual.EnumerateArray()))
                {
                    AssertSame(one, other, path);
                }

                break;
            case JsonValueKind.Number:
                double number = expected.GetDouble();
                Assert.True(
                    Math.Abs(actual.GetDouble() - number) <= 1e-15 * Math.Abs(number), $"{path}: {number}, {actual}");
                break;
            default:
                Assert.True(expected.GetRawText() == actual.GetRawText(), $"{path}: {expected} is {actual}");
                break;
        }
    }
}
