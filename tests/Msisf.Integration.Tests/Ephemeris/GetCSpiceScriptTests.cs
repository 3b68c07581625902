using System.Runtime.Versioning;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>scripts/get-cspice.sh in a repository of its own, without a network.</summary>
[SupportedOSPlatform("linux")]
public sealed class GetCSpiceScriptTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("msis get cspice ");
    private readonly string _script;
    private readonly string _library;

    public GetCSpiceScriptTests()
    {
        string root = Path.Combine(_folder.FullName, "my repository");
        string helpers = Path.Combine(root, "scripts", "lib");
        Directory.CreateDirectory(helpers);
        Directory.CreateDirectory(Path.Combine(_folder.FullName, "bin"));
        _script = Path.Combine(root, "scripts", "get-cspice.sh");
        _library = Path.Combine(root, "lib", "native", "libcspice.so");
        File.Copy(Path.Combine(TestParts.RepositoryRoot, "scripts", "get-cspice.sh"), _script);
        foreach (string helper in Directory.EnumerateFiles(Path.Combine(TestParts.RepositoryRoot, "scripts", "lib")))
        {
            File.Copy(helper, Path.Combine(helpers, Path.GetFileName(helper)));
        }

        WriteCurl("exit 7");
    }

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void Run_NoSourceAndConnectionRefused_SaysWhatMsisWillUse()
    {
        (int exitCode, string output, string errors) = Run(namedLibrary: "");

        Assert.Equal(1, exitCode);
        Assert.Empty(output);
        Assert.EndsWith(
            "does not answer (curl: exit code 7); msis will use its built-in kernel reader.\n", errors, StringComparison.Ordinal);
        Assert.False(File.Exists(_library));
        Assert.Empty(Directory.GetFileSystemEntries(Path.GetDirectoryName(_library)!));
    }

    [Fact]
    public void Run_PageInsteadOfThePackage_IsRefused()
    {
        WriteCurl("while [ $# -gt 1 ]; do [ \"$1\" = --output ] && echo sorry > \"$2\"; shift; done");

        (int exitCode, _, string errors) = Run(namedLibrary: "");

        Assert.Equal(1, exitCode);
        Assert.Contains("is too small to be CSPICE", errors, StringComparison.Ordinal);
        Assert.False(File.Exists(_library));
    }

    [Fact]
    public void Run_NamedLibraryIsMissing_IsRefused()
    {
        (int exitCode, _, string errors) = Run(namedLibrary: "/none/libcspice.so");

        Assert.Equal(1, exitCode);
        Assert.StartsWith("get-cspice: MSISF_CSPICE is /none/libcspice.so, which is not CSPICE N0067; ", errors, StringComparison.Ordinal);
    }

    [RequiresFact(Part.CSpice)]
    public void Run_NamedLibrary_IsUsedWhereItIs()
    {
        (int exitCode, string output, _) = Run(Path.GetFullPath(TestParts.CSpiceLibrary!));

        Assert.Equal(0, exitCode);
        Assert.Equal(Path.GetFullPath(TestParts.CSpiceLibrary!) + "\n", output);
        Assert.False(File.Exists(_library));
    }

    [RequiresFact(Part.CSpice)]
    public void Run_SharedFolderBesideTheRepository_IsCopiedOnce()
    {
        string shared = Path.Combine(_folder.FullName, "shared", "cspice", "libcspice.so");
        Directory.CreateDirectory(Path.GetDirectoryName(shared)!);
        File.Copy(TestParts.CSpiceLibrary!, shared);

        (int exitCode, string output, _) = Run(namedLibrary: "");
        File.Delete(shared);
        (int secondExitCode, string secondOutput, _) = Run(namedLibrary: "");

        Assert.Equal((0, 0), (exitCode, secondExitCode));
        Assert.Equal(_library + "\n", output);
        Assert.Equal(output, secondOutput);
        Assert.Equal(File.ReadAllBytes(TestParts.CSpiceLibrary!), File.ReadAllBytes(_library));
        Assert.Equal([_library], Directory.GetFileSystemEntries(Path.GetDirectoryName(_library)!));
    }

    private void WriteCurl(string body)
    {
        string curl = Path.Combine(_folder.FullName, "bin", "curl");
        File.WriteAllText(curl, "#!/bin/sh\n" + body + "\n");
        File.SetUnixFileMode(curl, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
    }

    private ChildRun Run(string namedLibrary) =>
        ChildRun.Of("bash", [_script], _folder.FullName, environment: new Dictionary<string, string>
        {
            ["MSISF_CSPICE"] = namedLibrary,
            ["PATH"] = $"{Path.Combine(_folder.FullName, "bin")}{Path.PathSeparator}{Environment.GetEnvironmentVariable("PATH")}",
        });
}
