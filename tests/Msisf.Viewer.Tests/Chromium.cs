using Microsoft.Playwright;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Viewer.Tests;

/// <summary>
/// Debian's Chromium, started once for all tests of the project, by the driver that the package Microsoft.Playwright brings: nothing is
/// downloaded. Each start has a profile of its own.
/// </summary>
public sealed class Chromium : IAsyncLifetime
{
    /// <summary>The collection of the tests that use it.</summary>
    public const string Collection = "Chromium";

    /// <summary>ms: far above what any step takes, even on a busy machine.</summary>
    public const float Limit = 120_000;

    private static readonly string[] Arguments =
    [
        "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--disable-background-networking", "--no-first-run",
        "--disable-component-update", "--disable-sync",
    ];

    private IPlaywright? _playwright;
    private IBrowser? _browser;

    /// <summary>Starts it; without Chromium the tests that need it are skipped by its name.</summary>
    public async Task InitializeAsync()
    {
        string? program = TestParts.Program("chromium");
        if (program is null && MissingParts.ReasonToSkip([Part.Chromium]) is not null)
        {
            return;
        }

        _playwright = await Playwright.CreateAsync();
        _browser = await _playwright.Chromium.LaunchAsync(
            new BrowserTypeLaunchOptions { ExecutablePath = program, Args = Arguments, Timeout = Limit });
    }

    /// <summary>Ends it.</summary>
    public async Task DisposeAsync()
    {
        if (_browser is not null)
        {
            await _browser.CloseAsync();
        }

        _playwright?.Dispose();
    }

    /// <summary>A window with a memory of its own.</summary>
    public async Task<IBrowserContext> WindowAsync(int width, int height, bool hasTouch = false)
    {
        IBrowserContext window = await _browser!.NewContextAsync(new BrowserNewContextOptions
        {
            ViewportSize = new ViewportSize { Width = width, Height = height },
            AcceptDownloads = true,
            HasTouch = hasTouch,
            Permissions = ["clipboard-read", "clipboard-write"],
        });
        window.SetDefaultTimeout(Limit);
        return window;
    }
}
