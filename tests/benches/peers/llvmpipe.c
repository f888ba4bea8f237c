// Draws a scene by Mesa's llvmpipe: OpenGL ES 3 without a window.
//
//     llvmpipe SCENE
//     llvmpipe --check
//
// The second one says whether there is an llvmpipe, and draws nothing. SCENE is what src/file.rs writes; lines and answers are those of src/painter.rs. What is timed ends where glFinish says
// that the picture is in memory; it is not read back.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void fail(const char *what) {
    fprintf(stderr, "llvmpipe: %s\n", what);
    exit(1);
}

static void *take(FILE *file, size_t bytes) {
    void *data = malloc(bytes);
    if (!data || fread(data, 1, bytes, file) != bytes) fail("the scene's file ends early");
    return data;
}

static const char *VERTEX =
    "#version 300 es\n"
    "uniform mat4 to_clip; uniform vec3 light;\n"
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) in vec2 uv;\n"
    "out vec2 place; out float intensity;\n"
    "void main() {\n"
    "    gl_Position = to_clip * vec4(position, 1.0);\n"
    "    place = uv;\n"
    "    intensity = dot(normal, light);\n"
    "}\n";

static const char *FRAGMENT =
    "#version 300 es\n"
    "precision highp float; precision highp sampler2D;\n"
    "uniform sampler2D texels;\n"
    "in vec2 place; in float intensity;\n"
    "out vec4 color;\n"
    "void main() { color = vec4(texture(texels, place).rgb * max(intensity, 0.0), 1.0); }\n";

static GLuint compiled(GLenum kind, const char *source) {
    GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    GLint good;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) fail("a shader does not compile");
    return shader;
}

static void open_context(void) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    PFNEGLGETPLATFORMDISPLAYEXTPROC display_of =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    EGLDisplay display =
        display_of ? display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL) : EGL_NO_DISPLAY;
    if (!eglInitialize(display, NULL, NULL)) fail("EGL has no display without a surface");
    EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) fail("EGL has no configuration");
    eglBindAPI(EGL_OPENGL_ES_API);
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) fail("EGL has no context");
    if (!strstr((const char *)glGetString(GL_RENDERER), "llvmpipe")) fail("another renderer would draw");
}

int main(int count, char **arguments) {
    if (count == 2 && strcmp(arguments[1], "--check") == 0) {
        open_context();
        return 0;
    }
    FILE *file = count == 2 ? fopen(arguments[1], "rb") : NULL;
    if (!file) fail("give the file of a scene");
    // Width, height, vertices, indices, the texture's width and height and whether it is repeated; the matrix by columns
    // and the light.
    uint32_t *sizes = take(file, 7 * 4);
    float *uniforms = take(file, 19 * 4);
    float *vertices = take(file, (size_t)sizes[2] * 32);
    uint32_t *indices = take(file, (size_t)sizes[3] * 4);
    uint8_t *texels = take(file, (size_t)sizes[4] * sizes[5] * 4);
    fclose(file);
    int width = (int)sizes[0], height = (int)sizes[1];

    open_context();
    GLuint buffers[2], planes[2], target, texture, program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, VERTEX));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, FRAGMENT));
    glLinkProgram(program);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, uniforms);
    glUniform3fv(glGetUniformLocation(program, "light"), 1, uniforms + 16);

    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizes[2] * 32, vertices, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)sizes[3] * 4, indices, GL_STATIC_DRAW);
    int lengths[] = {3, 3, 2}, at[] = {0, 12, 24};
    for (GLuint n = 0; n < 3; n++) {
        glEnableVertexAttribArray(n);
        glVertexAttribPointer(n, lengths[n], GL_FLOAT, GL_FALSE, 32, (const char *)NULL + at[n]);
    }

    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, (int)sizes[4], (int)sizes[5], 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

    GLint wrap = sizes[6] ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);

    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glGenRenderbuffers(2, planes);
    GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT32F}, ends[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int n = 0; n < 2; n++) {
        glBindRenderbuffer(GL_RENDERBUFFER, planes[n]);
        glRenderbufferStorage(GL_RENDERBUFFER, formats[n], width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, ends[n], GL_RENDERBUFFER, planes[n]);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) fail("there is no such picture");
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    // Rounding to a level of colour is what is asked for, no pattern that hides it.
    glDisable(GL_DITHER);
    glClearColor(0, 0, 0, 1);
    printf("%s, %s\n", glGetString(GL_RENDERER), glGetString(GL_VERSION));
    fflush(stdout);

    char line[4096];
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = 0;
        // By the clock on the wall, and the time for which this program had processors.
        clockid_t clocks[] = {CLOCK_MONOTONIC, CLOCK_PROCESS_CPUTIME_ID};
        struct timespec start[2], end[2];
        for (int n = 0; n < 2; n++) clock_gettime(clocks[n], &start[n]);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawElements(GL_TRIANGLES, (GLsizei)sizes[3], GL_UNSIGNED_INT, NULL);
        glFinish();
        long taken[2];
        for (int n = 0; n < 2; n++) {
            clock_gettime(clocks[n], &end[n]);
            taken[n] = (end[n].tv_sec - start[n].tv_sec) * 1000000000L + end[n].tv_nsec - start[n].tv_nsec;
        }
        if (glGetError() != GL_NO_ERROR) fail("OpenGL refuses something");
        if (strncmp(line, "picture ", 8) == 0) {
            uint8_t *rgba = malloc((size_t)width * height * 4);
            glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
            char *path = strchr(line + 8, ' ');
            FILE *out = path ? fopen(path + 1, "wb") : NULL;
            if (!rgba || !out) fail("the picture cannot be written");
            for (size_t n = 0; n < (size_t)width * height; n++) fwrite(rgba + 4 * n, 1, 3, out);
            if (fclose(out) != 0) fail("the picture cannot be written");
            free(rgba);
        }
        printf("%ld %ld\n", taken[0], taken[1]);
        fflush(stdout);
    }
    return 0;
}
