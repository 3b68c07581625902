using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>wwwroot/js/grid.js over the picture of an oblique camera.</summary>
[Collection(Chromium.Collection)]
public class GridTests(ModulePage page) : IClassFixture<ModulePage>
{
    /// <summary>How many ends of the grid's lines are within the picture, and neither on the limb nor at a pole.</summary>
    private const string LooseEnds = """
        async () => {
            const { Overlay } = await import('/js/overlay.js');
            const { Grid } = await import('/js/grid.js');
            const { seenParts, project, dot, subtract } = await import('/js/geometry.js');
            const canvas = document.createElement('canvas');
            [canvas.width, canvas.height] = [720, 680];
            const view = { latitude: -30, longitude: 352, altitude: 1100000, tilt: 24, heading: 180, roll: 0, fov: 40 };
            const overlay = new Overlay(canvas, view, { width: 720, height: 680 });
            const lines = [];
            overlay.line = points => lines.push(points);
            new Grid(overlay).draw();
            const ends = lines.flatMap(points => seenParts(overlay.camera, points)).flatMap(part => [part[0], part.at(-1)]);
            const isLoose = point => {
                const [x, y] = project(overlay.camera, overlay.lens, point);
                const sine = dot(subtract(overlay.camera.position, point), point) / dot(point, point);
                return x > 1 && y > 1 && x < 719 && y < 679 && sine > 1e-4 && Math.hypot(point[0], point[1]) > 1;
            };
            return [lines.length, ends.filter(isLoose).length];
        }
        """;

    [RequiresFact(Part.Chromium)]
    public async Task Draw_ObliqueView_NoLineEndsBeforeTheLimb()
    {
        int[] found = await page.EvaluateAsync<int[]>(LooseEnds);

        Assert.InRange(found[0], 10, 200); // five and five at least: the widest step with five in the view; a finer one would draw hundreds
        Assert.Equal(0, found[1]);
    }
}
