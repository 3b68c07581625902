using System.Text.Json;
using Msisf.App.Host;
using Msisf.App.Serving;
using Msisf.App.Settings;
using Msisf.Core.Scene;

namespace Msisf.Server;

/// <summary>POST /v1/trajectory: the states of a batch file or an OEM that a client sends, or of an orbit at given times.</summary>
internal sealed class TrajectoryEndpoint(FrameService frames, ProgramHost host)
{
    private const int MostTimes = 1001;

    public async Task AnswerAsync(HttpContext context)
    {
        JsonElement json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        frames.CollectWarnings();
        IReadOnlyDictionary<string, JsonElement> members = JsonText.Members(json);
        IReadOnlyList<SpacecraftState> states = members.Keys.Order(StringComparer.Ordinal).ToArray() switch
        {
            ["name", "text"] => await OfTextAsync(
                JsonText.Of(members["name"], "'name'"), JsonText.Of(members["text"], "'text'"), context.RequestAborted)
                .ConfigureAwait(false),
            ["frame", "times"] => await OfOrbitAsync(members["frame"], members["times"], context.RequestAborted).ConfigureAwait(false),
            _ => throw new UsageException(
                "the request has 'name' and 'text' of a batch file or an OEM, or 'frame' with an orbit and 'times', a list of MJD."),
        };
        await JsonBody.SendAsync(context.Response, new StatesAnswer(states.Select(state => state.ToNumbers()))).ConfigureAwait(false);
    }

    /// <summary>The readers of missions' files want files.</summary>
    private async Task<IReadOnlyList<SpacecraftState>> OfTextAsync(string name, string text, CancellationToken client)
    {
        string path = Path.GetTempFileName();
        try
        {
            await File.WriteAllTextAsync(path, text, client).ConfigureAwait(false);
            RequestedFrame requested = frames.ReadDefault();
            return await frames.RunAsync(
                requested,
                (_, _, end) => (IReadOnlyList<SpacecraftState>)[.. ServedBatch.Frames(
                    path, requested, frames.Sessions.Ephemeris, host, end).Select(frame => frame.State)],
                client).ConfigureAwait(false);
        }
        catch (MsisfException wrong) when (wrong.Message.Contains(path, StringComparison.Ordinal))
        {
            throw new BadInputException(wrong.Message.Replace(path, name, StringComparison.Ordinal), wrong);
        }
        finally
        {
            File.Delete(path);
        }
    }

    private Task<IReadOnlyList<SpacecraftState>> OfOrbitAsync(JsonElement frame, JsonElement times, CancellationToken client)
    {
        if (times.ValueKind != JsonValueKind.Array || times.GetArrayLength() is 0 or > MostTimes)
        {
            throw new UsageException($"'times' is a list of 1 to {MostTimes} MJD.");
        }

        RequestedFrame[] requested = [.. times.EnumerateArray().Select(
            time => frames.Read(frame, new Dictionary<string, JsonElement> { [CameraOptions.Time.Key] = time }))];
        return frames.RunAsync(
            requested[0],
            (session, _, end) => (IReadOnlyList<SpacecraftState>)[.. requested.Select(one => session.Prepare(one.Place!, end).State)],
            client);
    }
}

/// <summary>States of a trajectory, each as a row of a batch file.</summary>
internal sealed record StatesAnswer(IEnumerable<double[]> States);
