using System.Globalization;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>Pictures between the exact ones: as quick as the screen, like those of the server, and lost without harm.</summary>
[Collection(Chromium.Collection)]
public class SmoothTests(Chromium chromium, ViewerServer server)
{
    private const string OverClavius = "names=false&samples=1&latitude=-50&longitude=345&altitude=900000";

    /// <summary>Counts the pictures of the movement, and notes when the exact one was there after it.</summary>
    private const string Count = """
        () => {
            window.drawn = [];
            const draw = WebGL2RenderingContext.prototype.drawElements;
            WebGL2RenderingContext.prototype.drawElements = function (...all) {
                window.drawn.push(performance.now());
                return draw.apply(this, all);
            };
        }
        """;

    /// <summary>
    /// Drags in the page itself, as a mouse of 60 Hz does, for some seconds and until there are three pictures; answers the median
    /// rate of its pictures.
    /// </summary>
    private const string Drag = """
        async seconds => {
            const stage = document.getElementById('stage');
            const send = (type, x, y, buttons) => stage.dispatchEvent(new PointerEvent(type, {
                pointerId: 1, pointerType: 'mouse', clientX: x, clientY: y, buttons, bubbles: true }));
            stage.setPointerCapture = () => { };
            const start = performance.now();
            window.drawn = [];
            send('pointerdown', 600, 300, 1);
            let t = 0;
            while (t < seconds || (window.drawn.length < 3 && t < 60)) {
                t = (performance.now() - start) / 1000;
                send('pointermove', 600 + 150 * Math.sin(2 * t), 300 + 100 * Math.cos(1.4 * t), 1);
                await new Promise(resolve => setTimeout(resolve, 8));
            }
            const between = window.drawn.slice(1).map((time, index) => time - window.drawn[index]).sort((a, b) => a - b);
            send('pointerup', 600, 300, 0);
            return between.length ? 1000 / between[Math.floor(between.length / 2)] : 0;
        }
        """;

    /// <summary>
    /// In the long form the rates that are promised (docs/viewer.md): 30 pictures a second while the server draws, 60 while it does not.
    /// </summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Drag_1280x720_ShowsPicturesBetweenTheExactOnes()
    {
        double seconds = TestLength.IsLong ? 10.0 : 0.5;
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, $"{OverClavius}&fit=false&width=1280&height=720", 1360, 820, hasPanel: false,
            expected: "ERR_FAILED");
        await viewer.Page.EvaluateAsync(Count);
        await viewer.WaitAsync("() => document.getElementById('progress').hidden");

        int before = viewer.Images;
        double drawing = 0.0;
        await Within.Seconds(120, "an exact image while the mouse moves", DragUntilAsync());
        await viewer.AtRestAsync();
        await viewer.Page.RouteAsync("**/v1/**", route => route.AbortAsync());
        await viewer.Page.EvaluateAsync("WebSocket.prototype.send = () => { }");
        double idle = await viewer.Page.EvaluateAsync<double>(Drag, seconds);

        string words = string.Create(CultureInfo.InvariantCulture, $"{drawing:F1} while the server draws, {idle:F1} while it does not");
        Assert.True(!TestLength.IsLong || (drawing >= 30.0 && idle >= 59.0), words);
        Assert.True(drawing > 0.0 && idle > 0.0, words);

        async Task DragUntilAsync()
        {
            do
            {
                drawing = await viewer.Page.EvaluateAsync<double>(Drag, seconds);
            }
            while (viewer.Images == before);
        }
    }

    /// <summary>A picture between is the server's own picture of that place, but for what was not seen before.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task Warp_OfTheImageBeside_IsLikeTheExactOne()
    {
        const string compare = """
            async () => {
                const { Warp } = await import('/js/warp.js');
                const { State } = await import('/js/state.js');
                const { renderPlane } = await import('/js/server.js');
                const size = { width: 320, height: 240 };
                const frame = async view => {
                    const state = new State();
                    state.look({ mjd: 55307, latitude: -20, longitude: 10, altitude: 300000, tilt: 35, heading: 40, ...view });
                    const options = state.frame(size);
                    const depth = await renderPlane({ ...options, layers: ['depth'], 'layers-precision': 'single' });
                    return { view: state.view, image: await renderPlane(options), depth };
                };
                const before = await frame({});
                const after = await frame({ latitude: -20.4, longitude: 10.5, heading: 43, tilt: 33, roll: 2 });
                const canvas = document.createElement('canvas');
                const warp = new Warp(canvas, () => { });
                const differences = view => {
                    warp.draw(view, size);
                    const copy = Object.assign(document.createElement('canvas'), size);
                    const pen = copy.getContext('2d');
                    pen.drawImage(canvas, 0, 0);
                    const { data } = pen.getImageData(0, 0, size.width, size.height);
                    const truth = view === before.view ? before.image.values : after.image.values;
                    let [holes, sum, sky] = [0, 0, 0];
                    truth.forEach((level, i) => {
                        const isHole = data[4 * i + 3] === 0;
                        holes += isHole;
                        sum += isHole ? 0 : Math.abs(level - data[4 * i]);
                        sky += level === 0;
                    });
                    return [holes / truth.length, sum / truth.length, truth.reduce((all, level) => all + level, 0) / truth.length];
                };
                warp.take(before.image, before.depth, before.view);
                return [...differences(before.view), ...differences(after.view)];
            }
            """;
        await using ViewerPage viewer = await ViewerPage.OpenAsync(chromium, server, OverClavius);

        double[] found = await viewer.Page.EvaluateAsync<double[]>(compare);

        Assert.InRange(found[0], 0.0, 0.02); // the same place: hardly a hole
        Assert.InRange(found[1], 0.0, 0.3); // and the same levels
        Assert.True(found[5] > 20.0, $"the picture has a mean level of {found[5]}");
        Assert.InRange(found[3], 0.005, 0.25); // beside it: what comes into the picture is a hole
        Assert.InRange(found[4], 0.0, 4.0); // all else is where the server has it: a shift of 2 px would be twice that
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task LostGraphics_MovesAsWithoutThem_AndComesBack()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, OverClavius, hasPanel: false, expected: "CONTEXT_LOST");
        await viewer.MoveAsync(() => viewer.Page.EvaluateAsync(
            "window.taken = document.getElementById('warp').getContext('webgl2').getExtension('WEBGL_lose_context'); taken.loseContext()"));
        Assert.True(await viewer.Page.IsHiddenAsync("#warp"));
        int images = viewer.Images;
        await MoveByWheelAsync(viewer);
        Assert.True(viewer.Images > images, "the pictures of the stream are shown");

        await viewer.Page.EvaluateAsync("taken.restoreContext()");
        await viewer.WaitAsync("() => !document.getElementById('warp').getContext('webgl2').isContextLost()");
        await viewer.Page.EvaluateAsync(Count);
        await Within.Seconds(120, "a picture between the exact ones", MoveUntilDrawnAsync());

        async Task MoveUntilDrawnAsync()
        {
            while (await viewer.Page.EvaluateAsync<int>("drawn.length") == 0)
            {
                await MoveByWheelAsync(viewer);
            }
        }
    }

    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task WithoutWebGl_WorksByTheStreamAlone()
    {
        await using ViewerPage viewer = await ViewerPage.OpenAsync(
            chromium, server, OverClavius, hasPanel: false,
            before: "HTMLCanvasElement.prototype.getContext = (get => function (kind, ...all) {"
                + "return kind === 'webgl2' ? null : get.call(this, kind, ...all); })(HTMLCanvasElement.prototype.getContext)");
        int images = viewer.Images;
        await MoveByWheelAsync(viewer);

        Assert.True(viewer.Images > images);
        Assert.True(await viewer.Page.IsHiddenAsync("#warp"));
    }

    /// <summary>The page says that the server is gone, and draws on when another one answers at its address.</summary>
    [RequiresFact(Part.Chromium, Part.Ldem4)]
    public async Task LostServer_IsSaid_AndComesBack()
    {
        (RunningProgram first, string address) = ViewerServer.StartProgram(["serve", "--listen", "127.0.0.1:0"], server.Folder);
        await using ViewerPage viewer = await ViewerPage.OpenAtAsync(chromium, address, OverClavius, expected: "ERR_", hasPanel: false);
        first.Dispose();
        await viewer.Page.FocusAsync("#stage");
        await viewer.Page.Keyboard.PressAsync(".");
        await viewer.WaitAsync("() => /trying again/.test(document.getElementById('notice').textContent)");
        await viewer.WaitAsync("() => document.getElementById('mjd').value === '55308.04166667'");

        (RunningProgram second, string same) = ViewerServer.StartProgram(["serve", "--listen", address["http://".Length..]], server.Folder);
        using RunningProgram running = second;
        Assert.Equal(address, same);
        await viewer.AtRestAsync();
        Assert.True(await viewer.Page.IsHiddenAsync("#notice"));
        Assert.Equal(55308.04166667, await viewer.NumberAsync("mjd"));
    }

    private static Task MoveByWheelAsync(ViewerPage viewer) => viewer.MoveAsync(async () =>
    {
        await viewer.Page.Mouse.MoveAsync(500, 300);
        await viewer.Page.Mouse.WheelAsync(0, -100);
        await viewer.Page.Mouse.WheelAsync(0, -100);
    });
}
