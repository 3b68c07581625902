using System.Text.Json;
using Msisf.App.Illumination;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Terrain;

namespace Msisf.Server;

/// <summary>
/// POST /v1/ground, /v1/points, /v1/pixels and /v1/light: what the surface of a frame is at places, where it lies in the image, and how it
/// is lit over the month around the frame's time.
/// </summary>
internal sealed class PointsEndpoints(FrameService frames)
{
    /// <summary>Places of a request for light: each takes a horizon.</summary>
    private const int MostLitPlaces = 10;
    private static readonly string[] Place = ["latitude", "longitude"];

    public static RouteText AboutGround { get; } = new("Says how high the ground is at places of the Moon.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints("points", "[latitude, longitude]: degrees"),
    };

    public static RouteText AboutLight { get; } = new("Says how places are lit over the month around a time.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints("points", "[latitude, longitude]: degrees; at most 10"),
    };

    public static RouteText AboutPoints { get; } = new("Says where places of the Moon are seen in an image.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints(
            "points",
            "[latitude, longitude] or [latitude, longitude, height]: degrees, m over the sphere of 1737400 m",
            most: 3),
        Answer = ApiSchemas.OfList("pixels", ApiSchemas.ImagePoint, isNullable: false),
    };

    public static RouteText AboutPixels { get; } = new("Says what points of an image show.", AnswerForm.Json)
    {
        Body = ApiSchemas.OfPoints("pixels", "[x, y]: pixels from 1 for the middle of the first one, x right, y down"),
        Answer = ApiSchemas.OfList("points", ApiSchemas.SurfacePoint, isNullable: true),
    };

    public async Task GroundAsync(HttpContext context)
    {
        double[] heights = await AnswersAsync(
            context, Place, (truth, point) => truth.HeightAt(point[0], point[1])).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new HeightsAnswer(heights)).ConfigureAwait(false);
    }

    public async Task PointsAsync(HttpContext context)
    {
        PixelReading[] pixels = await AnswersAsync(
            context, [.. Place, "height"],
            (truth, point) => truth.Of(point[0], point[1], point.Length > 2 ? point[2] : null)).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new PixelsAnswer(pixels)).ConfigureAwait(false);
    }

    public async Task PixelsAsync(HttpContext context)
    {
        PointsRequest request = await ReadAsync(context, "pixels", ["x", "y"]).ConfigureAwait(false);
        RequestedFrame frame = request.Frame;
        SurfaceReading?[] points = await frames.RunAsync(
            frame,
            (session, threads, end) => Read(session, frame, request.Points, threads, end),
            context.RequestAborted,
            samples: frame.IsTraceable ? 0 : FrameService.SamplesOf(frame.Settings)).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, new SurfacePointsAnswer(points)).ConfigureAwait(false);
    }

    /// <summary>The light of places over the month, hour by hour.</summary>
    public async Task LightAsync(HttpContext context)
    {
        PointsRequest request = await ReadAsync(context, "points", Place).ConfigureAwait(false);
        if (request.Points.Count is 0 or > MostLitPlaces)
        {
            throw new UsageException($"'points' has {request.Points.Count} places; 1 to {MostLitPlaces} are answered.");
        }

        if (request.Frame.Settings.Native?.Refine is not null)
        {
            throw new UsageException(
                $"'{NativeOptions.Refine.Key}' is for pictures: horizons are those of the model, without invented detail. Leave it out.");
        }

        Vector3D[] directions = [.. request.Points.Select(
            point => new SurfacePlace(point[0], point[1], 0.0, isOverTerrain: false)
                .ToPositionBodyFixed(_ => MoonConstants.ReferenceRadius).Normalized())];
        MonthOfLight month = await frames.RunAsync(
            request.Frame,
            (session, threads, end) => MonthOfLight.Find(
                session.Model, directions, session.Prepare(request.Frame.Place!, end).State.Time, frames.SunAt, threads, end),
            context.RequestAborted,
            isLarge: true).ConfigureAwait(false);
        await JsonBody.SendAsync(context.Response, month).ConfigureAwait(false);
    }

    private async Task<T[]> AnswersAsync<T>(HttpContext context, string[] fields, Func<FrameTruth, double[], T> answer)
    {
        PointsRequest request = await ReadAsync(context, "points", fields).ConfigureAwait(false);
        return await frames.RunAsync(
            request.Frame,
            (session, _, end) =>
            {
                FrameTruth truth = session.TruthOf(session.Prepare(request.Frame.Place!, end));
                return AtEach(request.Points, point => answer(truth, point), end);
            },
            context.RequestAborted).ConfigureAwait(false);
    }

    private async Task<PointsRequest> ReadAsync(HttpContext context, string name, string[] fields)
    {
        JsonElement json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        return PointsRequest.Read(json, name, fields, frames);
    }

    private static SurfaceReading?[] Read(
        RenderSession session, RequestedFrame frame, IReadOnlyList<double[]> pixels, int threads, CancellationToken cancellation)
    {
        PreparedFrame prepared = session.Prepare(frame.Place!, cancellation);
        FrameTruth truth = session.TruthOf(prepared);
        SurfaceReading?[] readings = frame.IsTraceable
            ? AtEach(pixels, pixel => truth.At(pixel[0], pixel[1]), cancellation)
            : session.ReadDrawn(prepared, pixels, threads, cancellation);
        return [.. readings.Zip(pixels, (reading, pixel) => reading is null ? null : truth.WithShade(reading, pixel[1]))];
    }

    private static T[] AtEach<T>(IReadOnlyList<double[]> points, Func<double[], T> answer, CancellationToken end) =>
    [
        .. points.Select(point =>
        {
            end.ThrowIfCancellationRequested();
            return answer(point);
        }),
    ];
}

/// <summary>A request with a frame and a list of points.</summary>
internal sealed record PointsRequest(RequestedFrame Frame, IReadOnlyList<double[]> Points)
{
    /// <summary>Numbers of a point that must be there.</summary>
    private const int Needed = 2;

    /// <summary>Reads the body of a request.</summary>
    /// <param name="name">Name of the list.</param>
    /// <param name="fields">Names of the numbers of a point; from the third on they may be left out.</param>
    /// <exception cref="MsisfException">A member is missing, unknown or wrong.</exception>
    public static PointsRequest Read(JsonElement json, string name, string[] fields, FrameService frames)
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
            frames.Read(frame),
            [.. list.EnumerateArray().Select((point, index) => PointOf(point, name, index, fields))]);
    }

    private static double[] PointOf(JsonElement point, string name, int index, string[] fields)
    {
        double[]? numbers = point.ValueKind == JsonValueKind.Array && point.EnumerateArray().All(IsNumber)
            ? [.. point.EnumerateArray().Select(number => number.GetDouble())]
            : null;
        return numbers is not null && numbers.Length >= Needed && numbers.Length <= fields.Length
            ? numbers
            : throw new UsageException(Invariant($"'{name}', entry {index + 1}: the numbers [{string.Join(", ", fields)}] are needed."));
    }

    private static bool IsNumber(JsonElement value) =>
        value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) && double.IsFinite(number);
}

/// <summary>Heights of places.</summary>
/// <param name="Heights">m over the reference radius.</param>
internal sealed record HeightsAnswer(double[] Heights);

/// <summary>Where places are in an image.</summary>
internal sealed record PixelsAnswer(PixelReading[] Pixels);

/// <summary>What points of an image show.</summary>
/// <param name="Points">Null for the sky.</param>
internal sealed record SurfacePointsAnswer(SurfaceReading?[] Points);
