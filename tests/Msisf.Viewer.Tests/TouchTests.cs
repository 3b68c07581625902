using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>Fingers on a telephone: one orbits and reads, two pinch, turn and tilt.</summary>
[Collection(Chromium.Collection)]
public class TouchTests(Chromium chromium, ViewerServer server)
{
    private const string Small = "names=false&samples=1&latitude=-20&longitude=10&altitude=500000&mjd=55310";

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Fingers_OrbitPinchTiltReadAndPin()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, Small, 360, 740, hasPanel: false, hasTouch: true);
        ICDPSession fingers = await viewer.Page.Context.NewCDPSessionAsync(viewer.Page);

        await viewer.MoveAsync(() => MoveAsync(fingers, [(180, 250, 180, 330)]));
        Assert.True(await viewer.NumberAsync("latitude") > -19.9, "the ground follows the finger down");
        Assert.Equal(500.0, await viewer.NumberAsync("altitude"), 1e-3); // km: one finger turns, and leaves the height but for rounding

        await viewer.MoveAsync(() => MoveAsync(fingers, [(160, 300, 100, 300), (200, 300, 260, 300)]));
        Assert.InRange(await viewer.NumberAsync("altitude"), 50.0, 300.0);
        Assert.Equal(0.0, await viewer.NumberAsync("tilt"), Rounding.OfPlaces);

        double altitude = await viewer.NumberAsync("altitude");
        await viewer.MoveAsync(() => MoveAsync(fingers, [(140, 300, 140, 220), (220, 300, 220, 220)]));
        Assert.InRange(await viewer.NumberAsync("tilt"), 10.0, 40.0);
        Assert.Equal(altitude, await viewer.NumberAsync("altitude"), 1e-6); // km: tilting turns about the ground in the middle

        await viewer.MoveAsync(() => MoveAsync(fingers, [(120, 300, 180, 240), (240, 300, 180, 360)]));
        Assert.InRange(await viewer.NumberAsync("heading"), 20.0, 340.0);

        await SendAsync(fingers, "touchStart", (180, 300));
        await SendAsync(fingers, "touchEnd");
        await viewer.Page.Locator("#hover").WaitForAsync();
        Assert.Equal("–", await viewer.ReadAsync("Pixel", "A")); // a tap reads

        await SendAsync(fingers, "touchStart", (200, 310));
        await viewer.WaitAsync("() => document.getElementById('readings').dataset.pins === 'A'"); // a finger that stays pins
        await SendAsync(fingers, "touchEnd");
    }

    private static async Task MoveAsync(ICDPSession session, (int X, int Y, int ToX, int ToY)[] fingers)
    {
        const int steps = 8;
        await SendAsync(session, "touchStart", [.. fingers.Select(finger => (finger.X, finger.Y))]);
        for (int step = 1; step <= steps; step++)
        {
            await SendAsync(session, "touchMove", [.. fingers.Select(finger => (
                finger.X + ((finger.ToX - finger.X) * step / steps), finger.Y + ((finger.ToY - finger.Y) * step / steps)))]);
        }

        await SendAsync(session, "touchEnd");
    }

    private static async Task SendAsync(ICDPSession session, string type, params (int X, int Y)[] places) => await session.SendAsync(
        "Input.dispatchTouchEvent",
        new Dictionary<string, object>
        {
            ["type"] = type,
            ["touchPoints"] = places.Select((place, id) => new { x = place.X, y = place.Y, id }).ToArray(),
        });
}
