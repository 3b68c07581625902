using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Twins;

/// <summary>The cubes of twins.py, made once; none where a part is missing.</summary>
public sealed class TwinCubes : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    /// <summary>Makes them.</summary>
    public TwinCubes()
    {
        if (LroNac.IsThere && TestParts.PythonPackage("numpy") is not null)
        {
            Numpy("make", Models, _folder.Path);
        }
    }

    /// <summary>The camera models of real images from USGS ALE's tests.</summary>
    public static string Models => Path.Combine(LroNac.Folder, "..", "cameras");

    /// <summary>The path of a cube.</summary>
    /// <param name="name">E.g. "m3".</param>
    public string this[string name] => _folder[$"{name}.cub"];

    public void Dispose() => _folder.Dispose();

    /// <summary>Runs twins.py, and returns what it prints.</summary>
    public static string Numpy(params string[] arguments) => ChildRun.Of(
        TestParts.Python!,
        ["-B", Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Integration.Tests", "Twins", "twins.py"), .. arguments],
        TestParts.RepositoryRoot).Succeeded().Output.TrimEnd();
}
