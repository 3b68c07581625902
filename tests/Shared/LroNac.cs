namespace Msisf.TestSupport;

/// <summary>The kernels of LRO's image M103595705LE from USGS ALE's tests, where they are installed beside the repository.</summary>
internal static class LroNac
{
    /// <summary>The folder.</summary>
    public static string Folder => Path.Combine(TestParts.RepositoryRoot, "..", "shared", "missions", "lro_nac");

    /// <summary>Whether it is there.</summary>
    public static bool IsThere => File.Exists(Clock) && File.Exists(Isd);

    /// <summary>The spacecraft's clock.</summary>
    public static string Clock => Path.Combine(Folder, "lro_clkcor_2019239_v00.tsc");

    /// <summary>The camera model ("ISD") of the image.</summary>
    public static string Isd => Path.Combine(Folder, "..", "cameras", "lrolroc_isd.json");

    /// <summary>Clock, frames, instrument and its addendum.</summary>
    public static IReadOnlyList<string> TextKernels =>
    [
        Clock, .. ((string[])["lro_frames_2014049_v01.tf", "lro_lroc_v18.ti", "lro_instrumentAddendum_v04.ti"])
            .Select(name => Path.Combine(Folder, name)),
    ];

    /// <summary>The trajectory.</summary>
    public static string Spk => Path.Combine(Folder, "M103595705LE_1.bsp");

    /// <summary>The attitudes of the spacecraft and of the camera on it.</summary>
    public static IReadOnlyList<string> Cks =>
    [
        Path.Combine(Folder, "moc42r_2009181_2009213_v14_1_sliced_-85000.bc"),
        Path.Combine(Folder, "lrolc_2009181_2009213_v10_1_sliced_-85600.bc"),
    ];
}
