using System.Text.Json;
using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests.Modules;

/// <summary>Calls the functions of the page's modules in Chromium, without a server: the files come from the sources.</summary>
public sealed class ModulePage(Chromium chromium) : IAsyncLifetime
{
    private const string Origin = "http://viewer.test";

    private const string CallOfModule = """
        async ([module, name, parameters]) => {
            try {
                return { value: (await import(`/js/${module}.js`))[name](...JSON.parse(parameters)) ?? null };
            } catch (error) {
                return { error: error.message };
            }
        }
        """;

    private IBrowserContext? _window;
    private IPage? _page;

    /// <summary>Nothing yet: a test that is skipped needs no page.</summary>
    public Task InitializeAsync() => Task.CompletedTask;

    /// <summary>Closes the page.</summary>
    public async Task DisposeAsync()
    {
        if (_window is not null)
        {
            await _window.CloseAsync();
        }
    }

    /// <summary>The result of a function.</summary>
    public async Task<JsonElement> CallAsync(string module, string name, params object[] parameters) =>
        (await AnswerAsync(module, name, parameters)).GetProperty("value");

    /// <summary>The message of the error that a function throws.</summary>
    public async Task<string?> ErrorOfAsync(string module, string name, params object[] parameters) =>
        (await AnswerAsync(module, name, parameters)).GetProperty("error").GetString();

    /// <summary>The result of a script that imports modules by itself.</summary>
    public async Task<T> EvaluateAsync<T>(string script)
    {
        _page ??= await OpenAsync();
        return await _page.EvaluateAsync<T>(script);
    }

    private async Task<JsonElement> AnswerAsync(string module, string name, object[] parameters)
    {
        _page ??= await OpenAsync();
        return (await _page.EvaluateAsync(CallOfModule, new[] { module, name, JsonSerializer.Serialize(parameters) }))!.Value;
    }

    private async Task<IPage> OpenAsync()
    {
        _window = await chromium.WindowAsync(400, 400);
        IPage page = await _window.NewPageAsync();
        await page.RouteAsync($"{Origin}/**", route =>
        {
            string path = new Uri(route.Request.Url).AbsolutePath;
            return path == "/"
                ? route.FulfillAsync(new RouteFulfillOptions { ContentType = "text/html", Body = "<!DOCTYPE html><title>Modules</title>" })
                : route.FulfillAsync(new RouteFulfillOptions
                {
                    ContentType = "text/javascript",
                    Path = Path.Combine(TestParts.RepositoryRoot, "src", "Msisf.Server", "wwwroot", path[1..]),
                });
        });
        await page.GotoAsync(Origin);
        return page;
    }
}
