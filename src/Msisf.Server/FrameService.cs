using System.Diagnostics;
using System.Text.Json;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Ephemeris;
using Msisf.Core.Render.Options;
using Msisf.Core.Time;

namespace Msisf.Server;

/// <summary>Reads the frames of requests and does their work in the queue. Thread-safe.</summary>
internal sealed class FrameService : IAsyncDisposable
{
    /// <summary>How long stopped work may take to notice that it is stopped.</summary>
    public static readonly TimeSpan TimeToStop = TimeSpan.FromSeconds(1);

    /// <summary>Samples of the largest image that does not wait for larger ones.</summary>
    private const int SmallSamples = 1024 * 1024;

    private readonly RequestLog _log;
    private readonly RenderQueue _queue;

    /// <summary>Looks for the models and maps, and opens none.</summary>
    /// <exception cref="BadInputException">There is no elevation model.</exception>
    public FrameService(ServeSettings settings, ProgramHost host)
    {
        Settings = settings;
        _log = (RequestLog)host.Log;
        Names = new ServedNames(settings, host);
        Sessions = new RenderSessions(host);
        _queue = new RenderQueue(Environment.ProcessorCount, settings.Queue, settings.TimeLimit);
        Metrics = new ServerMetrics(_queue, Sessions, host.Clock);
        Answers = new FrameAnswers(new StreamPool());
    }

    public ServeSettings Settings { get; }

    /// <summary>The files that requests may name.</summary>
    public ServedNames Names { get; }

    public RenderSessions Sessions { get; }

    public ServerMetrics Metrics { get; }

    /// <summary>Draws frames and writes their answers.</summary>
    public FrameAnswers Answers { get; }

    /// <summary>Reads the options of a frame.</summary>
    /// <param name="json">The options.</param>
    /// <param name="changes">Options that replace those; null for none.</param>
    /// <param name="needsPlace">Whether the options must say where the camera is.</param>
    /// <param name="isOfSeveral">Whether other cameras have the options too: the motion may be meant for them alone.</param>
    /// <exception cref="MsisfException">They are wrong, or the image is too large.</exception>
    public RequestedFrame Read(
        JsonElement json, IReadOnlyDictionary<string, JsonElement>? changes = null, bool needsPlace = true, bool isOfSeveral = false)
    {
        RequestedFrame requested;
        try
        {
            requested = JsonOptions.Read(JsonText.Members(json), changes, needsPlace, Names, Settings, isOfSeveral);
        }
        catch (MsisfException wrong) when (wrong is UsageException or BadInputException && wrong.Message.Length > Problem.LongestQuote)
        {
            string message = (changes?.Values ?? []).Prepend(json).Aggregate(
                wrong.Message, (text, given) => JsonText.WithoutLongTexts(text, given, Problem.LongestQuote));
            throw new UsageException(message, wrong) { Options = wrong.Options };
        }

        long pixels = (long)requested.Settings.Width * requested.Settings.Height;
        return pixels <= Settings.MaxPixels
            ? requested
            : throw new RefusedException(
                StatusCodes.Status413PayloadTooLarge,
                Invariant(
                    $"an image of {requested.Settings.Width} x {requested.Settings.Height} px is larger than the server's --max-pixels of "
                        + $"{Settings.MaxPixels} px. Use a smaller --width and --height."));
    }

    /// <summary>A frame with the defaults of all options, for what needs no camera.</summary>
    public RequestedFrame ReadDefault() => Read(JsonElement.Parse("{}"), needsPlace: false);

    /// <summary>The leap seconds for requests that give no options of the ephemeris.</summary>
    public TimeScale TimeScale() => Sessions.Ephemeris.Of(ReadDefault().Settings).TimeScale();

    /// <summary>Where the Sun is at times, m, BODY_FIXED, for requests that give no options of the ephemeris.</summary>
    /// <exception cref="MsisfException">The kernels do not cover a time.</exception>
    public Vector3D[] SunAt(IEnumerable<Instant> times)
    {
        RenderSettings settings = ReadDefault().Settings;
        IEphemeris engine = Sessions.Ephemeris.Of(settings).Engine();
        return [.. times.Select(time => engine.SunPositionBodyFixed(time, settings.Aberration))];
    }

    /// <summary>Collects the warnings of a request for its answer.</summary>
    public IReadOnlyList<string> CollectWarnings() => _log.Collect();

    /// <param name="work">Receives the session and the number of threads.</param>
    /// <param name="samples">Samples that are drawn; 0 for what is not an image.</param>
    /// <param name="isLarge">Whether the work is that of a large image, however many samples it has.</param>
    public Task<T> RunAsync<T>(
        RequestedFrame requested, Func<RenderSession, int, CancellationToken, T> work, CancellationToken client, long samples = 0,
        bool isLarge = false) =>
        _queue.RunAsync(
            new Demand(AskingClient.Name, samples, isLarge || samples > SmallSamples),
            (threads, end) =>
            {
                using SharedCache<RenderSession>.Lease session = Sessions.Rent(requested);
                return work(session.Value, threads, end);
            },
            client);

    /// <param name="place">Where the camera is.</param>
    /// <param name="shared">Positions of the Sun that other images of the same request know; null for none.</param>
    public async Task DrawAsync(
        RequestedFrame requested, TrajectorySettings place, AnswerForm form, Answer answer, CancellationToken client,
        SharedReadings? shared = null)
    {
        AnswerPlan plan = AnswerPlan.Of(form, requested.Settings);
        plan.Check(form, requested.Settings, Settings.MaxMegabytes);
        long start = Stopwatch.GetTimestamp();
        await RunAsync(
            requested,
            (session, threads, end) =>
            {
                answer.AddTime("wait", start);
                FrameAnswers.Draw(answer, session, session.Prepare(place, end, shared), form, threads, end);
                return true;
            },
            client,
            SamplesOf(requested.Settings),
            plan.IsSentAsMade).ConfigureAwait(false);
        Metrics.FrameDrawn(Stopwatch.GetElapsedTime(start));
    }

    /// <summary>Samples of an image, from which its duration is estimated.</summary>
    public static long SamplesOf(RenderSettings settings)
    {
        long acrossPixel = settings.Native.Render.Adaptive is null
            ? settings.Native.Render.SubsamplesPerAxis
            : AdaptiveSampling.SubsamplesPerAxis;
        return settings.Width * acrossPixel * settings.Height * acrossPixel;
    }

    /// <summary>Closes all models, but not under work that does not end: it would read memory that is gone.</summary>
    public async ValueTask DisposeAsync()
    {
        if (await _queue.EndsWithinAsync(TimeToStop).ConfigureAwait(false))
        {
            Sessions.Dispose();
            Names.Dispose();
            Metrics.Dispose();
            _queue.Dispose();
        }
    }
}
