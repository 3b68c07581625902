using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using Msisf.Adapters.IO;
using Msisf.Core.Errors;
using Msisf.Synthesis;
using Xunit;

namespace Msisf.Architecture.Tests;

/// <summary>Cli uses Adapters uses Core, never back; Core is pure; native calls live in one namespace.</summary>
public sealed class LayerTests
{
    /// <summary>The compiler puts it into every iterator method.</summary>
    private const string UsedByEachIterator = "System.Environment.get_CurrentManagedThreadId";

    private static readonly Assembly Core = typeof(MsisfException).Assembly;
    private static readonly Assembly Synthesis = typeof(SyntheticTerrain).Assembly;
    private static readonly Assembly Adapters = typeof(AtomicFile).Assembly;
    private static readonly Assembly Cli = Assembly.Load("msis");

    [Fact]
    public void Core_References_NothingOfOurs() =>
        Assert.DoesNotContain(Core.GetReferencedAssemblies(), name => name.Name is "Msisf.Adapters" or "Msisf.Synthesis" or "msis");

    [Fact]
    public void Synthesis_References_CoreAndNothingElseOfOurs() =>
        Assert.Equal(
            ["Msisf.Core"],
            Synthesis.GetReferencedAssemblies().Select(name => name.Name!).Where(
                name => !name.StartsWith("System.", StringComparison.Ordinal)));

    [Fact]
    public void Adapters_References_CoreButNotCli()
    {
        Assert.Contains(Adapters.GetReferencedAssemblies(), name => name.Name == "Msisf.Core");
        Assert.DoesNotContain(Adapters.GetReferencedAssemblies(), name => name.Name == "msis");
    }

    [Fact]
    public void Core_References_OnlyTheRuntimeAndMathNet() =>
        Assert.All(Core.GetReferencedAssemblies(), name => Assert.True(
            name.Name!.StartsWith("System.", StringComparison.Ordinal) || name.Name is "MathNet.Numerics",
            $"Core references {name.Name}"));

    [Theory]
    [InlineData("System.IO.File")]
    [InlineData("System.IO.FileStream")]
    [InlineData("System.IO.Directory")]
    [InlineData("System.Environment")]
    [InlineData("System.Diagnostics.Process")]
    [InlineData("System.Console")]
    [InlineData("System.TimeProvider")]
    [InlineData("System.Random")]
    [InlineData("System.Net.Http.HttpClient")]
    public void CoreAndSynthesis_DoNotUse_TheWorld(string forbidden) =>
        Assert.DoesNotContain(
            MembersUsedBy(Core).Concat(MembersUsedBy(Synthesis)),
            member => member.StartsWith($"{forbidden}.", StringComparison.Ordinal) && member != UsedByEachIterator);

    [Fact]
    public void NativeCalls_Live_InTheInteropNamespaceOnly()
    {
        IEnumerable<MethodInfo> native =
            from assembly in (Assembly[])[Core, Synthesis, Adapters, Cli]
            from type in assembly.GetTypes()
            from method in type.GetMethods(
                BindingFlags.Static | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)
            where method.Attributes.HasFlag(MethodAttributes.PinvokeImpl)
            select method;

        MethodInfo[] found = [.. native];
        Assert.NotEmpty(found);
        Assert.All(found, method => Assert.StartsWith("Msisf.Adapters.Interop", method.DeclaringType!.FullName, StringComparison.Ordinal));
    }

    private static IReadOnlyList<string> MembersUsedBy(Assembly assembly)
    {
        using FileStream stream = File.OpenRead(assembly.Location);
        using PEReader image = new(stream);
        MetadataReader reader = image.GetMetadataReader();
        return
        [
            .. from handle in reader.MemberReferences
               let member = reader.GetMemberReference(handle)
               where member.Parent.Kind == HandleKind.TypeReference
               let type = reader.GetTypeReference((TypeReferenceHandle)member.Parent)
               select $"{reader.GetString(type.Namespace)}.{reader.GetString(type.Name)}.{reader.GetString(member.Name)}",
        ];
    }
}
