using System.Text.Json;
using Msisf.App.Preparation;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>POST /v1/render: draws a frame, or one with each camera of a rig.</summary>
internal sealed class RenderEndpoint(FrameService frames)
{
    public static RouteText About { get; } = new("Draws a frame, or one with each of several cameras.", AnswerForm.All)
    {
        Body = ApiSchemas.OfRender,
    };

    public async Task AnswerAsync(HttpContext context)
    {
        AnswerForm form = AnswerForm.Of(context.Request.Headers.Accept);
        JsonElement json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        IReadOnlyList<string> warnings = frames.CollectWarnings();
        IReadOnlyList<(string Prefix, RequestedFrame Frame)> images = Read(json, form);
        context.Response.OnStarting(() =>
        {
            if (warnings.Count > 0)
            {
                context.Response.Headers["X-Msisf-Warning"] = HeaderText.Of(string.Join(" ", warnings));
            }

            return Task.CompletedTask;
        });
        using Answer answer = frames.Answers.For(PlanOf(images, form), context.Response, form.IsMultipart);
        SharedReadings shared = new();
        foreach ((string prefix, RequestedFrame requested) in images)
        {
            answer.Prefix = prefix;
            await frames.DrawAsync(requested, requested.Place!, form, answer, context.RequestAborted, shared).ConfigureAwait(false);
        }

        await answer.SendAsync(context.Response, form.IsMultipart, context.RequestAborted).ConfigureAwait(false);
    }

    /// <summary>The images that are asked for, each with what the names of its parts begin with.</summary>
    private IReadOnlyList<(string Prefix, RequestedFrame Frame)> Read(JsonElement body, AnswerForm form)
    {
        if (body.ValueKind != JsonValueKind.Object || !body.TryGetProperty(StreamCamera.ListKey, out JsonElement cameras))
        {
            return [(string.Empty, frames.Read(body))];
        }

        IReadOnlyDictionary<string, JsonElement> members = JsonText.Members(body);
        if (!members.TryGetValue(StreamCamera.FrameKey, out JsonElement frame) || members.Count > 2)
        {
            throw new UsageException(
                $"a request with '{StreamCamera.ListKey}' has '{StreamCamera.FrameKey}', the options of all images, and nothing else.");
        }

        IReadOnlyList<StreamCamera> read = StreamCamera.Read(cameras, frame);
        return form.IsMultipart
            ? [.. StreamCamera.WithOnePlace(read, [.. read.Select(camera => camera.Of(frames, frame))])
                .Select((requested, index) => ($"{read[index].NameAt(index)}.", requested))]
            : throw new RefusedException(
                StatusCodes.Status406NotAcceptable,
                $"several cameras are answered in several parts, and {form.Main} is one. Accept {AnswerForm.Multipart}.");
    }

    /// <summary>What the answer will hold, checked for all images before the first one is drawn.</summary>
    private AnswerPlan PlanOf(IReadOnlyList<(string Prefix, RequestedFrame Frame)> images, AnswerForm form)
    {
        AnswerPlan[] plans = [.. images.Select(image => AnswerPlan.Of(form, image.Frame.Settings))];
        AnswerPlan all = plans[0] with { Bytes = plans.Sum(plan => plan.Bytes) };
        foreach ((AnswerPlan plan, (_, RequestedFrame image)) in plans.Zip(images))
        {
            (plan with { Bytes = all.Bytes }).Check(form, image.Settings, frames.Settings.MaxMegabytes);
        }

        return all;
    }
}

/// <summary>Texts in HTTP headers, which hold printable ASCII only.</summary>
internal static class HeaderText
{
    /// <summary>The text with a question mark for each other character.</summary>
    public static string Of(string text) => string.Concat(text.Select(letter => letter is >= ' ' and <= '~' ? letter : '?'));
}
