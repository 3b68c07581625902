using System.Text.Json;
using Msisf.Adapters.Input;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>wwwroot/js/features.js and overlay.js: which names are written, and where.</summary>
[Collection(Chromium.Collection)]
public class LabelTests(ModulePage page) : IClassFixture<ModulePage>
{
    private const int Width = 1224;
    private const int Height = 738;
    private const double Altitude = 7_178_500.0; // m: the whole Moon by a field of view of 40 degrees
    private const double Radius = 1_737_400.0;

    /// <summary>px: letters of a page whose text has 16 px.</summary>
    private const double Text = 14.0;

    [RequiresFact(Part.Chromium)]
    public async Task Names_OfTheWholeMoon_AreApartAndLeaveItToBeSeen()
    {
        double[][] boxes = await BoxesAsync(
            [.. PlaceNames.All.Select(place => new Feature(place.Name, place.Latitude, place.Longitude, place.Diameter, place.Diameter))]);

        double focal = Width / 2.0 / Math.Tan(double.DegreesToRadians(20.0));
        double disc = focal * Math.Tan(Math.Asin(Radius / (Radius + Altitude)));
        double covered = boxes.Sum(box => (box[2] - box[0]) * (box[3] - box[1])) / (Math.PI * disc * disc);
        Assert.InRange(covered, 0.03, 0.06); // 5 % and a part of the last name
        Assert.InRange(boxes.Length, 10, 25);
        for (int i = 0; i < boxes.Length; i++)
        {
            for (int j = 0; j < i; j++)
            {
                double aside = Math.Max(boxes[i][0] - boxes[j][2], boxes[j][0] - boxes[i][2]);
                double above = Math.Max(boxes[i][1] - boxes[j][3], boxes[j][1] - boxes[i][3]);
                Assert.True(Math.Max(aside, above) >= Text, $"names {i} and {j} are {aside} and {above} px apart");
            }
        }
    }

    /// <summary>A crater of 250 km is 49 px wide; 70 degrees from the middle, near the limb, it is 13 px.</summary>
    [RequiresTheory(Part.Chromium)]
    [InlineData(0.0, 1)]
    [InlineData(70.0, 0)]
    public async Task Names_NearTheLimb_NeedRoomAsSeen(double longitude, int count) =>
        Assert.Equal(count, (await BoxesAsync([new Feature("A", 0.0, longitude, 250e3, 250e3)])).Length);

    [RequiresFact(Part.Chromium)]
    public async Task Names_UnderABox_AreLeftOut() => Assert.Empty(
        (await BoxesAsync([new Feature("A", 0.0, 0.0, 250e3, 250e3)], [Width / 2, Height / 2, Width, Height]))[1..]);

    /// <summary>The boxes of the names; before them that which they are kept out of.</summary>
    private async Task<double[][]> BoxesAsync(IReadOnlyList<Feature> features, params double[][] covered)
    {
        string lists = JsonSerializer.Serialize(new { features, covered }, JsonSerializerOptions.Web);
        string boxes = await page.EvaluateAsync<string>(
            $$"""
            async () => {
                const [{ Overlay }, { drawNames }] = await Promise.all([import('/js/overlay.js'), import('/js/features.js')]);
                const { features, covered } = {{lists}};
                const canvas = Object.assign(document.createElement('canvas'), { width: {{Width}}, height: {{Height}} });
                const view = { latitude: 0, longitude: 0, altitude: {{Altitude}}, heading: 0, tilt: 0, roll: 0, fov: 40 };
                const overlay = new Overlay(canvas, view, { width: {{Width}}, height: {{Height}} });
                overlay.keepOut(covered);
                drawNames(overlay, features.sort((a, b) => b.weight - a.weight), null);
                return JSON.stringify(overlay.labels);
            }
            """);
        return JsonSerializer.Deserialize<double[][]>(boxes)!;
    }

    private sealed record Feature(string Name, double Latitude, double Longitude, double Diameter, double Weight);
}
