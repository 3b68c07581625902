using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Hapke's law for eight points at once, each with its own parameters, or for many with the same. It agrees with
/// <see cref="HapkeReflectance"/> to 1e-12, and is rearranged so that few divisions are left. It is computed in short steps, each for a
/// block of points: in a long step each operation would wait for the one before it, and without AVX-512 the compiler makes calls of them.
/// </summary>
internal readonly struct HapkeLanes
{
    /// <summary>Length of the buffer of <see cref="RadianceFactors"/>.</summary>
    public const int BufferLength = HapkePlaces.Length;

    /// <summary>Takes the parameters of eight points.</summary>
    /// <param name="scale">Factor of the radiance factors.</param>
    /// <param name="w">Single-scattering albedo.</param>
    /// <param name="b">Width of the Henyey-Greenstein lobes.</param>
    /// <param name="c">Weight of the backward lobe.</param>
    /// <param name="surgeAmplitude">B0.</param>
    /// <param name="surgeWidth">h.</param>
    /// <param name="slopeTangent">Tangent of the mean slope; 0 for a smooth surface.</param>
    public HapkeLanes(
        Vector512<double> scale, Vector512<double> w, Vector512<double> b, Vector512<double> c, Vector512<double> surgeAmplitude,
        Vector512<double> surgeWidth, Vector512<double> slopeTangent)
    {
        Vector512<double> one = Vector512<double>.One;
        Vector512<double> gamma = Vector512.Sqrt(one - w);
        Vector512<double> lobe = Vector512.Create(0.5) * (one - (b * b));
        Vector512<double> roughness = one + (Vector512.Create(Math.PI) * slopeTangent * slopeTangent);
        W = w;
        R0 = (one - gamma) / (one + gamma);
        NearestLobe = (one - b) * (one - b);
        FourLobeWidths = Vector512.Create(4.0) * b;
        Backward = lobe * (one + c);
        Forward = lobe * (one - c);
        SurgeAmplitude = surgeAmplitude;
        SurgeWidth = surgeWidth;
        Tangent = slopeTangent;
        Cotangent = one / slopeTangent;
        Chi = one / Vector512.Sqrt(roughness);
        Scale = scale * Vector512.Create(0.25) * w * Chi;
    }

    /// <summary>Factor of everything.</summary>
    public Vector512<double> Scale { get; }

    /// <summary>Single-scattering albedo.</summary>
    public Vector512<double> W { get; }

    /// <summary>Diffusive reflectance.</summary>
    public Vector512<double> R0 { get; }

    /// <summary>(1 - b)^2.</summary>
    public Vector512<double> NearestLobe { get; }

    /// <summary>4 b.</summary>
    public Vector512<double> FourLobeWidths { get; }

    /// <summary>Factor of the backward lobe.</summary>
    public Vector512<double> Backward { get; }

    /// <summary>Factor of the forward lobe.</summary>
    public Vector512<double> Forward { get; }

    /// <summary>B0.</summary>
    public Vector512<double> SurgeAmplitude { get; }

    /// <summary>h.</summary>
    public Vector512<double> SurgeWidth { get; }

    /// <summary>Tangent of the mean slope.</summary>
    public Vector512<double> Tangent { get; }

    /// <summary>Its inverse.</summary>
    public Vector512<double> Cotangent { get; }

    /// <summary>chi of the mean slope.</summary>
    public Vector512<double> Chi { get; }

    /// <summary>Computes radiance factors; 0 where a cosine is not above 0.</summary>
    /// <param name="law">The parameters.</param>
    /// <param name="cosIncidence">Cosines of the incidence angles, up to 1.</param>
    /// <param name="cosEmission">Cosines of the emission angles, up to 1.</param>
    /// <param name="phaseHaversine">sin^2 of half the phase angles, 0 to 1.</param>
    /// <param name="factors">Receives the radiance factors.</param>
    /// <param name="buffer">Memory of length <see cref="BufferLength"/>; its content does not matter.</param>
    public static void RadianceFactors(
        in HapkeLanes law,
        ReadOnlySpan<Vector512<double>> cosIncidence,
        ReadOnlySpan<Vector512<double>> cosEmission,
        ReadOnlySpan<Vector512<double>> phaseHaversine,
        Span<Vector512<double>> factors,
        Span<Vector512<double>> buffer)
    {
        ref Vector512<double> places = ref MemoryMarshal.GetReference(buffer[..BufferLength]);
        for (int start = 0; start < factors.Length; start += HapkePlaces.Block)
        {
            int count = Math.Min(HapkePlaces.Block, factors.Length - start);
            ref Vector512<double> incidence = ref MemoryMarshal.GetReference(cosIncidence.Slice(start, count));
            ref Vector512<double> emission = ref MemoryMarshal.GetReference(cosEmission.Slice(start, count));
            ref Vector512<double> phase = ref MemoryMarshal.GetReference(phaseHaversine.Slice(start, count));
            HapkeRoughLanes.SquareSines(ref places, ref incidence, ref emission, count);
            HapkeScatteringLanes.SquareLobes(law, ref places, ref phase, count);
            for (int root = 0; root < HapkePlaces.RootBlocks; root++)
            {
                LaneMath.InverseSqrt(buffer.Slice(HapkePlaces.Roots + (root * HapkePlaces.Block), count));
            }

            HapkeScatteringLanes.FindSingle(law, ref places, ref phase, count);
            HapkeRoughLanes.FindDirections(law, ref places, ref incidence, ref emission, ref phase, count);
            HapkeRoughLanes.FindAzimuths(ref places, count);
            HapkeRoughLanes.FindAngles(ref places, count);
            for (int exponent = 0; exponent < HapkePlaces.ExponentBlocks; exponent++)
            {
                LaneMath.ExpMinusOne(buffer.Slice(HapkePlaces.Exponents + (exponent * HapkePlaces.Block), count));
            }

            HapkeRoughLanes.FindEffectiveCosines(law, ref places, ref incidence, ref emission, count);
            HapkeScatteringLanes.SplitCosines(ref places, count);
            HapkeScatteringLanes.FindAbsorbed(law, ref places, count);
            HapkeScatteringLanes.Reflect(
                law, ref places, ref incidence, ref emission, ref MemoryMarshal.GetReference(factors.Slice(start, count)), count);
        }
    }
}
