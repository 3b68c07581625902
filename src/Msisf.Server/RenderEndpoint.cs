using System.Text.Json;
using Microsoft.AspNetCore.Http;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>POST /v1/render: draws a frame.</summary>
/// <param name="frames">Does the work.</param>
internal sealed class RenderEndpoint(FrameService frames)
{
    /// <summary>Describes the route.</summary>
    public static RouteText About { get; } = new("Draws a frame.", AnswerForm.All)
    {
        Body = document => new Microsoft.OpenApi.OpenApiSchemaReference(ApiSchemas.Frame, document),
    };

    /// <summary>Answers a request.</summary>
    public async Task AnswerAsync(HttpContext context)
    {
        AnswerForm form = AnswerForm.Of(context.Request.Headers.Accept);
        using JsonDocument json = await JsonBody.ReadAsync(context.Request).ConfigureAwait(false);
        IReadOnlyList<string> warnings = frames.CollectWarnings();
        RequestedFrame requested = frames.Read(json.RootElement);
        context.Response.OnStarting(() =>
        {
            if (warnings.Count > 0)
            {
                context.Response.Headers["X-Msisf-Warning"] = HeaderText.Of(string.Join(" ", warnings));
            }

            return Task.CompletedTask;
        });
        using Answer answer = frames.Answers.For(AnswerPlan.Of(form, requested.Settings), context.Response, form.IsMultipart);
        await frames.DrawAsync(requested, requested.Place!, form, answer, context.RequestAborted).ConfigureAwait(false);
        await answer.SendAsync(context.Response, form.IsMultipart, context.RequestAborted).ConfigureAwait(false);
    }
}

/// <summary>Texts in HTTP headers, which hold printable ASCII only.</summary>
internal static class HeaderText
{
    /// <summary>The text with a question mark for each other character.</summary>
    public static string Of(string text) => string.Concat(text.Select(letter => letter is >= ' ' and <= '~' ? letter : '?'));
}
