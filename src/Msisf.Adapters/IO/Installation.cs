namespace Msisf.Adapters.IO;

/// <summary>Where the program's own files are: the folder that holds <c>kernels/msisf.tm</c>.</summary>
public sealed class Installation
{
    private const string Landmark = "kernels/msisf.tm";

    private Installation(string root) => Root = root;

    /// <summary>The folder that holds kernels, lib and the rest.</summary>
    public string Root { get; }

    /// <summary>The meta-kernel that the project ships.</summary>
    public string MetaKernel => Path.Combine(Root, "kernels", "msisf.tm");

    /// <summary>The meta-kernel for bodies other than the Moon.</summary>
    public string BodiesMetaKernel => Path.Combine(Root, "kernels", "bodies.tm");

    /// <summary>The DTD of the meta files.</summary>
    public string MetaFileDtd => Path.Combine(Root, "lib", "MSISRendering.dtd");

    /// <summary>The folder with the presets of cameras.</summary>
    public string Cameras => Path.Combine(Root, "cameras");

    /// <summary>The command that starts the program in scripts that run later and elsewhere.</summary>
    public string Launcher => Path.Combine(Root, OperatingSystem.IsWindows() ? "msis.exe" : "msis");

    /// <summary>Searches a folder and the folders above it for the installation.</summary>
    /// <param name="programFolder">Folder of the running program.</param>
    /// <exception cref="ExternalPartException">No folder above holds the kernels.</exception>
    public static Installation Above(string programFolder)
    {
        for (DirectoryInfo? folder = new(programFolder); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, Landmark)))
            {
                return new Installation(folder.FullName);
            }
        }

        throw new ExternalPartException(
            $"{programFolder}: no folder from here upwards holds {Landmark}. Run msis from its own tree, as it was cloned.");
    }
}
