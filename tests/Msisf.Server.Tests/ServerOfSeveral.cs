using Msisf.App.Settings;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>A server with a model of the whole Moon and a map of the surroundings of the south pole.</summary>
public sealed class ServerOfSeveral : IAsyncLifetime, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    /// <summary>Label of the model of the whole Moon, LDEM_2_SYNTHETIC.</summary>
    public string Moon { get; private set; } = string.Empty;

    /// <summary>Label of the map, LDEM_80S_10000M_SYNTHETIC.</summary>
    public string Map { get; private set; } = string.Empty;

    /// <summary>The server.</summary>
    public RunningServer Running { get; private set; } = null!;

    public async Task InitializeAsync()
    {
        (Moon, Map) = (SyntheticModels.Make(_folder.Path, "--res", "2"), SyntheticModels.MakePolar(_folder.Path, 10000));
        Running = await RunningServer.StartAsync((SurfaceOptions.Ldem, Map), (SurfaceOptions.Ldem, Moon));
    }

    public async Task DisposeAsync()
    {
        await Running.DisposeAsync();
        Running.Dispose();
    }

    public void Dispose() => _folder.Dispose();
}
